#include <algorithm>
#include <map>
#include <optional>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/finger_joint.hpp"
#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/recorded_name.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

struct SkeletonNames {
  std::vector<RecordedName> names;
  std::vector<int> parent, depth;
  BodyTerm only_side = BodyTerm::filler;  ///< of all joints, if no name has a side

  std::optional<int> parent_of(int joint) const {
    return parent[joint] < 0 ? std::nullopt : std::optional(parent[joint]);
  }
  bool is_below(int joint, int ancestor) const {
    do {
      joint = parent[joint];
    } while (joint >= 0 && joint != ancestor);
    return joint >= 0;
  }
  bool is_of_side(int joint, BodyTerm side) const {
    return names[joint].has(side) || only_side == side;
  }
};

SkeletonNames skeleton_of(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents, Side hand) {
  SkeletonNames skeleton;
  std::map<std::string, int> index;
  for (int j = 0; j < std::ssize(names); ++j) {
    skeleton.names.push_back(parse_recorded_name(names[j]));
    const auto entry = index.find(parents[j]);
    const int parent = entry == index.end() ? -1 : entry->second;
    skeleton.parent.push_back(parent);
    skeleton.depth.push_back(parent < 0 ? 0 : skeleton.depth[parent] + 1);
    index.emplace(names[j], j);
  }
  if (std::ranges::none_of(skeleton.names, [](const RecordedName& name) {
        return name.has(BodyTerm::left) || name.has(BodyTerm::right);
      }))
    skeleton.only_side = hand == Side::left ? BodyTerm::left : BodyTerm::right;
  return skeleton;
}

using NameTest = bool (*)(const RecordedName&);

bool names_finger(const RecordedName& n) {
  return std::ranges::any_of(kFingerTerms, [&](BodyTerm finger) { return n.has(finger); }) ||
         n.has(BodyTerm::finger);
}
bool names_forearm(const RecordedName& n) {
  return n.has(BodyTerm::forearm) || (n.has(BodyTerm::arm) && n.has(BodyTerm::lower));
}
bool names_upper_arm(const RecordedName& n) {
  return n.has(BodyTerm::upper_arm) || (n.has(BodyTerm::arm) && !names_forearm(n));
}
bool names_shoulder(const RecordedName& n) { return n.has(BodyTerm::shoulder); }
bool names_elbow(const RecordedName& n) { return n.has(BodyTerm::elbow); }
bool names_wrist(const RecordedName& n) { return n.has(BodyTerm::wrist) && !names_finger(n); }
bool names_hand(const RecordedName& n) {
  return n.has(BodyTerm::hand) && !names_finger(n) && !n.has(BodyTerm::tip);
}
bool names_hip(const RecordedName& n) {
  return n.has(BodyTerm::hip) || n.has(BodyTerm::thigh) ||
         (n.has(BodyTerm::leg) && n.has(BodyTerm::upper));
}
bool names_leg(const RecordedName& n) { return n.has(BodyTerm::leg) && !n.has(BodyTerm::lower); }

/// Returns the joint nearest to the root, below `ancestor` if given, whose name passes the test.
std::optional<int> first_joint(const SkeletonNames& skeleton, BodyTerm side, NameTest test,
                               std::optional<int> ancestor) {
  std::optional<int> first;
  for (int j = 0; j < std::ssize(skeleton.names); ++j) {
    const RecordedName& name = skeleton.names[j];
    if (!skeleton.is_of_side(j, side) || name.has(BodyTerm::twist) || !test(name)) continue;
    if (ancestor && !skeleton.is_below(j, *ancestor)) continue;
    if (!first || skeleton.depth[j] < skeleton.depth[*first]) first = j;
  }
  return first;
}

/// Returns the first joint that passes `test`; if there is no such joint, that of `otherwise`.
std::optional<int> first_joint(const SkeletonNames& skeleton, BodyTerm side,
                               std::optional<int> ancestor, NameTest test, NameTest otherwise) {
  const std::optional<int> joint = first_joint(skeleton, side, test, ancestor);
  return joint ? joint : first_joint(skeleton, side, otherwise, ancestor);
}

/// Returns true for a joint of the finger. 3ds Max Biped numbers fingers by the first digit, their
/// joints by the second: the thumb is Finger0, Finger01, …, the index finger Finger1, Finger11, ….
bool is_of_finger(const RecordedName& name, int finger) {
  if (name.has(BodyTerm::toe)) return false;
  if (name.has(kFingerTerms[finger])) return true;
  const bool counted = name.has(BodyTerm::finger) && !name.numbers.empty() &&
                       std::ranges::none_of(kFingerTerms, [&](BodyTerm f) { return name.has(f); });
  if (!counted) return false;
  int number = name.numbers[0];
  while (number >= 10) number /= 10;
  return number == finger;
}

/// Adds the names of the joints of a chain: the last four; those before are in the palm.
void add_chain(const std::vector<std::string>& names, const std::string& side,
               std::vector<int> chain, int finger, GuessedNames& guessed) {
  const std::vector<std::string> joints = finger_joint_names(finger);
  if (chain.size() > 4) chain.erase(chain.begin(), chain.end() - 4);
  // Indices in `joints` of the members of a chain, by the number of its members.
  static const std::vector<int> kThumbChains[] = {{}, {3}, {1, 3}, {1, 2, 3}, {0, 1, 2, 3}};
  static const std::vector<int> kFingerChains[] = {{}, {3}, {0, 3}, {0, 1, 3}, {0, 1, 2, 3}};
  const std::vector<int>& indices = (finger == 0 ? kThumbChains : kFingerChains)[chain.size()];
  for (int i = 0; i < std::ssize(chain); ++i)
    guessed.emplace_back(names[chain[i]], side + joints[indices[i]]);
}

/// Returns true if the name is that of the parent and "_end": an end site without a name.
bool is_unnamed_end(const SkeletonNames& skeleton, const std::vector<std::string>& names, int j) {
  const std::optional<int> parent = skeleton.parent_of(j);
  return parent && names[j] == names[*parent] + "_end";
}

/// Adds the names of joints that are side by side, as in a list of points: by their words alone.
void add_by_words(const SkeletonNames& skeleton, const std::vector<std::string>& names,
                  const std::string& side, const std::vector<int>& members, int finger,
                  GuessedNames& guessed) {
  std::map<std::string, int> joints;
  for (const int j : members) {
    if (is_unnamed_end(skeleton, names, j)) continue;
    const std::string joint = finger_joint_of(skeleton.names[j], finger);
    if (!joint.empty()) joints.emplace(joint, j);
  }
  for (const auto& [joint, j] : joints) guessed.emplace_back(names[j], side + joint);
}

void add_finger(const SkeletonNames& skeleton, const std::vector<std::string>& names,
                const std::string& side, int wrist, int finger, GuessedNames& guessed) {
  std::vector<int> members, chain;
  for (int j = 0; j < std::ssize(names); ++j) {
    if (!skeleton.is_below(j, wrist) || !is_of_finger(skeleton.names[j], finger)) continue;
    members.push_back(j);
    if (chain.empty() || skeleton.is_below(j, chain.back())) chain.push_back(j);
  }
  if (chain.size() == members.size()) {
    add_chain(names, side, std::move(chain), finger, guessed);
  } else {
    add_by_words(skeleton, names, side, members, finger, guessed);
  }
}

}  // namespace

GuessedNames guess_joints(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents, Side hand) {
  const SkeletonNames skeleton = skeleton_of(names, parents, hand);
  GuessedNames guessed;
  for (const auto& [side, begin] : {std::pair(BodyTerm::left, std::string("left_")),
                                    std::pair(BodyTerm::right, std::string("right_"))}) {
    const std::string& prefix = begin;  // clang 14 cannot capture structured bindings in lambdas
    const auto add = [&](std::optional<int> joint, const char* name) {
      if (joint) guessed.emplace_back(names[*joint], prefix + name);
    };
    add(first_joint(skeleton, side, {}, &names_hip, &names_leg), "hip");
    auto shoulder = first_joint(skeleton, side, {}, &names_upper_arm, &names_shoulder);
    auto elbow = first_joint(skeleton, side, shoulder, &names_elbow, &names_forearm);
    const auto wrist =
        first_joint(skeleton, side, elbow ? elbow : shoulder, &names_wrist, &names_hand);
    // What is above a hand alone, such as the root of the scene, has no side in its name.
    if (const auto above = wrist ? skeleton.parent_of(*wrist) : std::nullopt;
        !elbow && above && skeleton.names[*above].has(side))
      elbow = above;
    if (!shoulder && elbow) shoulder = skeleton.parent_of(*elbow);
    if (elbow || wrist) add(shoulder, "shoulder");
    add(elbow, "elbow");
    add(wrist, "wrist");
    if (!wrist) continue;
    for (int finger = 0; finger < std::ssize(kFingerNames); ++finger)
      add_finger(skeleton, names, prefix, *wrist, finger, guessed);
  }
  return guessed;
}

}  // namespace morphe::imports
