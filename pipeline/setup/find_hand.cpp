#include "pipeline/setup/find_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/setup/find_jaw.hpp"
#include "pipeline/setup/opposition.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kMaxHandLength_m = 0.35;  ///< along its links, from where the fingers branch
constexpr double kMinEndRatio = 0.7;       ///< of a gripper's second end to its first, in distance

/// The subtree of a frame: its greatest length along the links, and its last moving frames.
struct Subtree {
  double length_m = 0;
  std::vector<int> leaves;
};

Subtree subtree_of(const Kinematics& robot, int frame) {
  Subtree found;
  for (const int child : robot.children[frame]) {
    const Subtree further = subtree_of(robot, child);
    const double link_m = robot.frame(child).transform.translation().norm();
    found.length_m = std::max(found.length_m, link_m + further.length_m);
    found.leaves.insert(found.leaves.end(), further.leaves.begin(), further.leaves.end());
  }
  if (found.leaves.empty() && robot.moves(frame)) found.leaves = {frame};
  return found;
}

/// Appends to `roots` the frames nearest to the base at which short fingers branch.
void find_roots(const Kinematics& robot, int frame, std::vector<int>& roots) {
  const Subtree all = subtree_of(robot, frame);
  if (all.leaves.size() < 2) return;
  const auto& children = robot.children[frame];
  const auto branches = std::ranges::count_if(
      children, [&](int child) { return !subtree_of(robot, child).leaves.empty(); });
  if (branches > 1 && all.length_m <= kMaxHandLength_m) {
    roots.push_back(frame);
    return;
  }
  for (const int child : children) find_roots(robot, child, roots);
}

/// Returns the finger indicated by the names of joints and links, -1 if there is no indication.
int finger_from_names(const Kinematics& robot, const std::vector<int>& frames) {
  static constexpr std::pair<const char*, int> kWords[] = {
      {"thumb", 0},  {"index", 1}, {"fore", 1},   {"pointer", 1}, {"ring", 3},
      {"little", 4}, {"pinky", 4}, {"pinkie", 4}, {"thj", 0},     {"ffj", 1},
      {"mfj", 2},    {"rfj", 3},   {"lfj", 4},    {"middle", 2}};  // last, because phalanges have
                                                                   // this name as well
  for (const auto& [word, finger] : kWords) {
    for (const int f : frames) {
      const std::string text = lower_case(robot.frame(f).name + " " + robot.link[f]);
      if (text.find(word) != std::string::npos) return finger;
    }
  }
  return -1;
}

Vec3 last_joint_position(const Kinematics& robot, const Finger& finger) {
  return robot.pose(finger.frames.back()).translation();
}

/// Returns the axis of a finger's last joint in the sense in which it closes.
Vec3 closing_axis(const Kinematics& robot, const Finger& finger) {
  const int last = finger.frames.back();
  return robot.closing_sign(last) * robot.axis(last).direction;
}

bool driven_by_one_joint(const Kinematics& robot, const std::vector<Finger>& fingers) {
  std::set<int> drivers;
  for (const Finger& finger : fingers)
    for (const int f : finger.frames) drivers.insert(robot.frame(f).joint);
  return drivers.size() == 1;
}

/// Returns the two fingers of a gripper: the one that ends farthest from the palm, and that among
/// those of similar length whose end is farthest from the first.
std::vector<Finger> gripper_fingers(const Kinematics& robot, int root,
                                    std::vector<Finger> fingers) {
  const Vec3 palm = robot.pose(root).translation();
  const auto extent = [&](const Finger& finger) {
    return (last_joint_position(robot, finger) - palm).norm();
  };
  const auto first = std::ranges::max_element(fingers, {}, extent);
  const Vec3 end = last_joint_position(robot, *first);
  const double min_extent_m = kMinEndRatio * extent(*first);
  const auto second = std::ranges::max_element(fingers, {}, [&](const Finger& finger) {
    return finger.frames.back() == first->frames.back() ? -2
           : extent(finger) < min_extent_m              ? -1
                                           : (last_joint_position(robot, finger) - end).norm();
  });
  std::vector<Finger> ends = {*first, *second};
  if (second < first) std::swap(ends[0], ends[1]);
  return ends;
}

/// Finds the finger whose closing axis is the least similar to the others'.
std::ptrdiff_t find_thumb(const Kinematics& robot, const std::vector<Finger>& fingers) {
  std::vector<double> similarity(fingers.size(), 0);
  for (int i = 0; i < std::ssize(fingers); ++i)
    for (int k = 0; k < std::ssize(fingers); ++k)
      if (i != k)
        similarity[i] += closing_axis(robot, fingers[i]).dot(closing_axis(robot, fingers[k]));
  return std::ranges::min_element(similarity) - similarity.begin();
}

/// Numbers the fingers other than the thumb by the places of their last joints across the palm,
/// starting from the thumb's side.
void order_by_geometry(const Kinematics& robot, std::vector<Finger>& fingers) {
  std::swap(fingers[0], fingers[find_thumb(robot, fingers)]);
  const auto root = [&](const Finger& finger) {
    return robot.pose(finger.frames.front()).translation();
  };
  Vec3 across = Vec3::Zero();  // the axes of the fingers are directed across the palm
  for (int i = 1; i < std::ssize(fingers); ++i) across += closing_axis(robot, fingers[i]);
  across.normalize();
  Vec3 middle = Vec3::Zero();
  for (int i = 1; i < std::ssize(fingers); ++i)
    middle += root(fingers[i]) / static_cast<double>(fingers.size() - 1);
  const Vec3 thumb = 0.5 * (root(fingers[0]) + last_joint_position(robot, fingers[0])) - middle;
  if (thumb.dot(across) < 0) across = -across;
  std::ranges::stable_sort(
      fingers.begin() + 1, fingers.end(), std::ranges::greater{},
      [&](const Finger& finger) { return last_joint_position(robot, finger).dot(across); });
  for (int i = 0; i < std::ssize(fingers); ++i) {
    fingers[i].finger = i;
    fingers[i].finger_provenance = Provenance::derived;
  }
}

/// Sorts the fingers by their names, and moves chains without such a name to `left_out` if at least
/// kMinNamed others have one. Returns false if names do not tell each finger from the others.
bool order_by_names(const Kinematics& robot, std::vector<Finger>& fingers,
                    std::vector<LeftOut>& left_out) {
  constexpr std::size_t kMinNamed = 3;  // thumb and two more: then names are meant to be complete
  std::vector<Finger> named;
  std::vector<LeftOut> unnamed;
  std::set<int> names;
  for (Finger finger : fingers) {
    finger.finger = finger_from_names(robot, finger.frames);
    finger.finger_provenance = Provenance::read;
    if (finger.finger < 0) {
      unnamed.push_back({finger.body, "the others are named as fingers, it is not"});
    } else {
      named.push_back(finger);
      names.insert(finger.finger);
    }
  }
  const bool complete = unnamed.empty() || named.size() >= kMinNamed;
  if (names.size() < named.size() || !names.contains(0) || !complete) return false;
  fingers = std::move(named);
  left_out.insert(left_out.end(), unnamed.begin(), unnamed.end());
  std::ranges::sort(fingers, {}, &Finger::finger);
  return true;
}

void number_jaws(Hand& hand) {
  for (int k : {0, 1}) {
    hand.fingers[k].finger = k;
    hand.fingers[k].finger_provenance = Provenance::assumed;
  }
}

/// Returns true if each of two fingers has one joint, or one joint drives all chains and names tell
/// of no more than two fingers.
bool is_gripper(const Kinematics& robot, const std::vector<Finger>& fingers) {
  const auto one_joint = [&](const Finger& finger) { return driven_by_one_joint(robot, {finger}); };
  if (fingers.size() == 2 && std::ranges::all_of(fingers, one_joint)) return true;
  std::vector<Finger> named = fingers;
  std::vector<LeftOut> unnamed;
  return driven_by_one_joint(robot, fingers) &&
         !(order_by_names(robot, named, unnamed) && named.size() > 2);
}

void keep_five_fingers(Hand& hand) {
  while (hand.fingers.size() > kFingerCount) {
    hand.left_out.push_back(
        {hand.fingers.back().body, fmt::format("a person has {} fingers", kFingerCount)});
    hand.fingers.pop_back();
  }
}

void keep_two_jaws(const Kinematics& robot, Hand& hand) {
  const std::vector<Finger> all = hand.fingers;
  hand.fingers = gripper_fingers(robot, hand.root, all);
  for (const Finger& other : all)
    if (std::ranges::find(hand.fingers, other.body, &Finger::body) == hand.fingers.end())
      hand.left_out.push_back({other.body, "the jaws' joint moves it"});
}

/// Adds the fixed jaw beside the only moving one. `asked_for`: without asking for evidence.
bool add_fixed_jaw(const Kinematics& robot, const BodyPoints& points, bool asked_for, Hand& hand) {
  const Finger& jaw = hand.fingers.front();
  const std::optional<BodyPoint> fixed =
      asked_for ? farthest_beside(robot, jaw, points) : find_fixed_jaw(robot, jaw, points);
  if (!fixed) return false;
  hand.gripper = true;
  hand.fixed_jaw_end = fixed->position;
  hand.fingers.push_back({1, {}, Provenance::assumed, fixed->frame});
  number_jaws(hand);
  return true;
}

/// Returns the chains below a frame that may be fingers.
std::vector<Finger> chains_below(const Kinematics& robot, int root) {
  std::vector<Finger> chains;
  for (const int leaf : subtree_of(robot, root).leaves)
    if (const std::vector<int> frames = joint_frames_between(robot, root, leaf); !frames.empty())
      chains.push_back({0, frames, Provenance::assumed, leaf});
  return chains;
}

/// Returns the links that carry a gripper's only moving jaw, of a robot without other hands.
std::vector<int> find_jaw_roots(const Kinematics& robot, const BodyPoints& points) {
  std::vector<int> roots;
  for (const int leaf : subtree_of(robot, 0).leaves) {
    int first = leaf;  // of the frames that the jaw's joint moves, one after the other
    for (int f = leaf;
         f >= 0 && (!robot.moves(f) || robot.frame(f).joint == robot.frame(leaf).joint);
         f = robot.frame(f).parent)
      if (robot.moves(f)) first = f;
    const int root = robot.frame(first).parent;
    if (root < 0) continue;
    const Finger jaw{0, joint_frames_between(robot, root, leaf), Provenance::assumed, leaf};
    if (find_fixed_jaw(robot, jaw, points)) roots.push_back(root);
  }
  return roots;
}

}  // namespace

std::vector<int> find_hand_roots(const Kinematics& robot, const BodyPoints& points) {
  std::vector<int> roots;
  find_roots(robot, 0, roots);
  return roots.empty() ? find_jaw_roots(robot, points) : roots;
}

std::optional<Hand> find_hand(const Kinematics& robot, int root, bool named,
                              const BodyPoints& points) {
  Hand hand;
  hand.root = root;
  hand.fingers = chains_below(robot, hand.root);
  hand.left_out = leave_out_idle_chains(robot, hand.root, points, hand.fingers);
  if (hand.fingers.empty()) return std::nullopt;
  if (hand.fingers.size() == 1) {
    if (!add_fixed_jaw(robot, points, named, hand)) return std::nullopt;
    return hand;
  }
  hand.gripper = is_gripper(robot, hand.fingers);
  if (hand.gripper) {
    keep_two_jaws(robot, hand);
    number_jaws(hand);
    return hand;
  }
  if (!order_by_names(robot, hand.fingers, hand.left_out)) order_by_geometry(robot, hand.fingers);
  keep_five_fingers(hand);
  return hand;
}

}  // namespace morphe::setup
