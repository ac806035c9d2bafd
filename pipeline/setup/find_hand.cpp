#include "pipeline/setup/find_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"
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
  ends[0].finger = 0;
  ends[1].finger = 1;
  ends[0].finger_provenance = ends[1].finger_provenance = Provenance::assumed;
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

/// Numbers the fingers other than the thumb, starting from its side.
void order_by_geometry(const Kinematics& robot, std::vector<Finger>& fingers) {
  std::swap(fingers[0], fingers[find_thumb(robot, fingers)]);
  if (fingers.size() < 2) return;
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
  std::ranges::sort(fingers.begin() + 1, fingers.end(), std::ranges::greater{},
                    [&](const Finger& finger) { return root(finger).dot(across); });
  for (int i = 0; i < std::ssize(fingers); ++i) {
    fingers[i].finger = std::min<int>(i, kFingerCount - 1);
    fingers[i].finger_provenance = Provenance::derived;
  }
}

void identify_fingers(const Kinematics& robot, std::vector<Finger>& fingers) {
  std::set<int> names;
  for (Finger& finger : fingers) {
    finger.finger = finger_from_names(robot, finger.frames);
    finger.finger_provenance = Provenance::read;
    names.insert(finger.finger);
  }
  if (names.size() == fingers.size() && names.contains(0) && !names.contains(-1)) {
    std::ranges::sort(fingers, {}, &Finger::finger);
  } else {
    order_by_geometry(robot, fingers);
  }
}

}  // namespace

std::optional<Hand> find_hand(const Kinematics& robot, const std::string& link_name) {
  std::vector<int> roots;
  if (!link_name.empty()) {
    const auto link = robot.model->links.find(link_name);
    if (link == robot.model->links.end())
      throw InputError(
          fmt::format("{}: link '{}' does not exist", robot.model->file.string(), link_name));
    roots = {link->second};
  } else {
    find_roots(robot, 0, roots);
  }
  if (roots.empty()) return std::nullopt;
  if (roots.size() > 1) {
    std::vector<std::string> names;
    for (const int root : roots) names.push_back(robot.link[root]);
    throw InputError(fmt::format("{}: has {} hands, at {}: select one with --hand LINK",
                                 robot.model->file.string(), roots.size(), fmt::join(names, ", ")));
  }
  Hand hand;
  hand.root = roots.front();
  for (const int leaf : subtree_of(robot, hand.root).leaves)
    hand.fingers.push_back({0, joint_frames_between(robot, hand.root, leaf), Provenance::assumed});
  if (hand.fingers.size() < 2) return std::nullopt;
  hand.gripper = driven_by_one_joint(robot, hand.fingers);
  if (hand.gripper) {
    hand.fingers = gripper_fingers(robot, hand.root, std::move(hand.fingers));
  } else {
    identify_fingers(robot, hand.fingers);
  }
  return hand;
}

}  // namespace morphe::setup
