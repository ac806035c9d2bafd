#include <algorithm>
#include <map>
#include <optional>

#include "core/motion/human_motion.hpp"
#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/recorded_words.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

struct SkeletonNames {
  std::vector<RecordedWords> words;
  std::vector<int> parent, depth;

  std::optional<std::size_t> above(std::size_t joint) const {
    if (parent[joint] < 0) return std::nullopt;
    return parent[joint];
  }
  bool below(std::size_t joint, std::size_t ancestor) const {
    for (int at = parent[joint]; at >= 0; at = parent[at]) {
      if (static_cast<std::size_t>(at) == ancestor) return true;
    }
    return false;
  }
};

SkeletonNames skeleton_of(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents) {
  SkeletonNames skeleton;
  std::map<std::string, int> at;
  for (std::size_t j = 0; j < names.size(); ++j) {
    skeleton.words.push_back(parse_recorded_name(names[j]));
    const auto found = at.find(parents[j]);
    const int parent = found == at.end() ? -1 : found->second;
    skeleton.parent.push_back(parent);
    skeleton.depth.push_back(parent < 0 ? 0 : skeleton.depth[parent] + 1);
    at.emplace(names[j], static_cast<int>(j));
  }
  return skeleton;
}

using Test = bool (*)(const RecordedWords&);

bool any_finger(const RecordedWords& w) {
  return std::ranges::any_of(kFingerWords, [&](BodyWord f) { return w.has(f); }) ||
         w.has(BodyWord::finger);
}
bool names_forearm(const RecordedWords& w) {
  return w.has(BodyWord::forearm) || (w.has(BodyWord::arm) && w.has(BodyWord::lower));
}
bool names_upper_arm(const RecordedWords& w) {
  return w.has(BodyWord::upper_arm) || (w.has(BodyWord::arm) && !names_forearm(w));
}
bool names_shoulder(const RecordedWords& w) { return w.has(BodyWord::shoulder); }
bool names_elbow(const RecordedWords& w) { return w.has(BodyWord::elbow); }
bool names_wrist(const RecordedWords& w) { return w.has(BodyWord::wrist) && !any_finger(w); }
bool names_hand(const RecordedWords& w) {
  return w.has(BodyWord::hand) && !any_finger(w) && !w.has(BodyWord::tip);
}
bool names_hip(const RecordedWords& w) {
  return w.has(BodyWord::hip) || w.has(BodyWord::thigh) ||
         (w.has(BodyWord::leg) && w.has(BodyWord::upper));
}
bool names_leg(const RecordedWords& w) { return w.has(BodyWord::leg) && !w.has(BodyWord::lower); }

/// Returns the matching joint nearest to the root, of a side and below another joint if there is
/// one.
std::optional<std::size_t> first_joint(const SkeletonNames& skeleton, BodyWord side, Test says,
                                       std::optional<std::size_t> above = {}) {
  std::optional<std::size_t> first;
  for (std::size_t j = 0; j < skeleton.words.size(); ++j) {
    const RecordedWords& words = skeleton.words[j];
    if (!words.has(side) || words.has(BodyWord::twist) || !says(words)) continue;
    if (above && !skeleton.below(j, *above)) continue;
    if (!first || skeleton.depth[j] < skeleton.depth[*first]) first = j;
  }
  return first;
}

template <class... Tests>
std::optional<std::size_t> first_of(const SkeletonNames& skeleton, BodyWord side,
                                    std::optional<std::size_t> above, Tests... tests) {
  std::optional<std::size_t> found;
  ((found = found ? found : first_joint(skeleton, side, tests, above)), ...);
  return found;
}

/// Returns true for a joint of the finger. Biped numbers its fingers: "Finger0", "Finger01" the
/// thumb, "Finger1", "Finger11" the index finger.
bool is_of_finger(const RecordedWords& words, std::size_t finger) {
  if (words.has(BodyWord::toe)) return false;
  if (words.has(kFingerWords[finger])) return true;
  const bool counted = words.has(BodyWord::finger) && !words.numbers.empty() &&
                       std::ranges::none_of(kFingerWords, [&](BodyWord f) { return words.has(f); });
  if (!counted) return false;
  int number = words.numbers[0];
  while (number >= 10) number /= 10;
  return number == static_cast<int>(finger);
}

/// Adds the finger's joints along one chain; joints before the last four are inside the palm.
void add_finger(const SkeletonNames& skeleton, const std::vector<std::string>& names,
                const std::string& side, std::size_t wrist, std::size_t finger,
                GuessedNames& guessed) {
  std::vector<std::size_t> chain;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (!skeleton.below(j, wrist) || !is_of_finger(skeleton.words[j], finger)) continue;
    if (chain.empty() || skeleton.below(j, chain.back())) chain.push_back(j);
  }
  const std::vector<std::string> joints = finger_joint_names(finger);
  std::vector<std::size_t> slots;
  switch (chain.size()) {
    case 0:
      return;
    case 1:
      slots = {3};
      break;
    case 2:
      slots = {finger == kThumb ? 1u : 0u, 3};
      break;
    case 3:
      slots =
          finger == kThumb ? std::vector<std::size_t>{1, 2, 3} : std::vector<std::size_t>{0, 1, 3};
      break;
    default:
      chain.erase(chain.begin(), chain.end() - 4);
      slots = {0, 1, 2, 3};
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    guessed.emplace_back(names[chain[i]], side + joints[slots[i]]);
  }
}

}  // namespace

GuessedNames guess_joints(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents) {
  const SkeletonNames skeleton = skeleton_of(names, parents);
  GuessedNames guessed;
  for (const auto& [side, begin] : {std::pair(BodyWord::left, std::string("left_")),
                                    std::pair(BodyWord::right, std::string("right_"))}) {
    const std::string& prefix = begin;  // clang 14 cannot capture structured bindings in lambdas
    const auto add = [&](std::optional<std::size_t> joint, const char* name) {
      if (joint) guessed.emplace_back(names[*joint], prefix + name);
    };
    add(first_of(skeleton, side, {}, &names_hip, &names_leg), "hip");
    auto shoulder = first_of(skeleton, side, {}, &names_upper_arm, &names_shoulder);
    auto elbow = first_of(skeleton, side, shoulder, &names_elbow, &names_forearm);
    const auto wrist =
        first_of(skeleton, side, elbow ? elbow : shoulder, &names_wrist, &names_hand);
    if (!elbow && wrist) elbow = skeleton.above(*wrist);
    if (!shoulder && elbow) shoulder = skeleton.above(*elbow);
    if (elbow || wrist) add(shoulder, "shoulder");
    add(elbow, "elbow");
    add(wrist, "wrist");
    if (!wrist) continue;
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      add_finger(skeleton, names, prefix, *wrist, finger, guessed);
    }
  }
  return guessed;
}

}  // namespace morphe::imports
