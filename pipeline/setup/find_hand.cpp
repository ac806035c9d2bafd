#include "pipeline/setup/find_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <set>

#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr double kLongestHand_m = 0.35;  ///< along its links, from where the fingers part
constexpr double kShorterThanTip = 0.7;  ///< a gripper's other bars end before this share

/// What hangs below a frame: how far along links, and the frames that move last.
struct Below {
  double reach_m = 0;
  std::vector<int> leaves;
};

Below below(const Kinematics& robot, int frame) {
  Below found;
  for (const int child : robot.children[static_cast<std::size_t>(frame)]) {
    const Below further = below(robot, child);
    const double link_m = robot.frame(child).transform.translation().norm();
    found.reach_m = std::max(found.reach_m, link_m + further.reach_m);
    found.leaves.insert(found.leaves.end(), further.leaves.begin(), further.leaves.end());
  }
  if (found.leaves.empty() && robot.moves(frame)) found.leaves = {frame};
  return found;
}

/// The shallowest frames from which short fingers part.
void find_roots(const Kinematics& robot, int frame, std::vector<int>& roots) {
  const Below all = below(robot, frame);
  if (all.leaves.size() < 2) return;
  const auto& children = robot.children[static_cast<std::size_t>(frame)];
  const auto branches = std::ranges::count_if(
      children, [&](int child) { return !below(robot, child).leaves.empty(); });
  if (branches > 1 && all.reach_m <= kLongestHand_m) {
    roots.push_back(frame);
    return;
  }
  for (const int child : children) find_roots(robot, child, roots);
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The finger that joints and links are named after; -1: none.
int named_finger(const Kinematics& robot, const std::vector<int>& frames) {
  static constexpr std::pair<const char*, int> kWords[] = {
      {"thumb", 0},  {"index", 1}, {"fore", 1},   {"pointer", 1}, {"ring", 3},
      {"little", 4}, {"pinky", 4}, {"pinkie", 4}, {"thj", 0},     {"ffj", 1},
      {"mfj", 2},    {"rfj", 3},   {"lfj", 4},    {"middle", 2}};  // the last: phalanges are called
                                                                   // so, too
  for (const auto& [word, finger] : kWords) {
    for (const int f : frames) {
      const std::string text =
          lower_case(robot.frame(f).name + " " + robot.link[static_cast<std::size_t>(f)]);
      if (text.find(word) != std::string::npos) return finger;
    }
  }
  return -1;
}

Vec3 end_of(const Kinematics& robot, const Finger& finger) {
  return robot.pose(finger.frames.back()).translation();
}

/// Of a finger's last joint, in the sense in which it closes.
Vec3 closing_axis(const Kinematics& robot, const Finger& finger) {
  const int last = finger.frames.back();
  return robot.closing_sense(last) * robot.axis(last).direction;
}

bool one_driver(const Kinematics& robot, const std::vector<Finger>& fingers) {
  std::set<int> drivers;
  for (const Finger& finger : fingers) {
    for (const int f : finger.frames) drivers.insert(robot.frame(f).joint);
  }
  return drivers.size() == 1;
}

/// The two ends of a gripper: the farthest one, and the one farthest from it that is about as long.
std::vector<Finger> gripper_ends(const Kinematics& robot, int root, std::vector<Finger> fingers) {
  const Vec3 palm = robot.pose(root).translation();
  const auto reach = [&](const Finger& finger) { return (end_of(robot, finger) - palm).norm(); };
  const auto first = std::ranges::max_element(fingers, {}, reach);
  const Vec3 end = end_of(robot, *first);
  const double least_m = kShorterThanTip * reach(*first);
  const auto apart = [&](const Finger& finger) {
    const bool other = finger.frames.back() != first->frames.back();
    return !other ? -2 : reach(finger) < least_m ? -1 : (end_of(robot, finger) - end).norm();
  };
  const auto second = std::ranges::max_element(fingers, {}, apart);
  std::vector<Finger> ends = {*first, *second};
  if (second < first) std::swap(ends[0], ends[1]);
  ends[0].finger = 0;
  ends[1].finger = 1;
  ends[0].named = ends[1].named = Sure::assumed;
  return ends;
}

/// The finger whose closing axis is least like the others'.
std::size_t odd_one_out(const Kinematics& robot, const std::vector<Finger>& fingers) {
  std::vector<double> alike(fingers.size(), 0);
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    for (std::size_t k = 0; k < fingers.size(); ++k) {
      if (i != k) alike[i] += closing_axis(robot, fingers[i]).dot(closing_axis(robot, fingers[k]));
    }
  }
  return static_cast<std::size_t>(std::ranges::min_element(alike) - alike.begin());
}

/// Numbers the fingers beside the thumb from its side on.
void order_by_place(const Kinematics& robot, std::vector<Finger>& fingers) {
  std::swap(fingers[0], fingers[odd_one_out(robot, fingers)]);
  if (fingers.size() < 2) return;
  const auto root = [&](const Finger& finger) {
    return robot.pose(finger.frames.front()).translation();
  };
  Vec3 across = Vec3::Zero();  // the fingers' axes are across the palm
  for (std::size_t i = 1; i < fingers.size(); ++i) across += closing_axis(robot, fingers[i]);
  across.normalize();
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 1; i < fingers.size(); ++i) {
    middle += root(fingers[i]) / static_cast<double>(fingers.size() - 1);
  }
  const Vec3 thumb = 0.5 * (root(fingers[0]) + end_of(robot, fingers[0])) - middle;
  if (thumb.dot(across) < 0) across = -across;
  std::ranges::sort(fingers.begin() + 1, fingers.end(), std::ranges::greater{},
                    [&](const Finger& finger) { return root(finger).dot(across); });
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    fingers[i].finger = static_cast<int>(std::min(i, kFingers - 1));
    fingers[i].named = Sure::derived;
  }
}

void identify(const Kinematics& robot, std::vector<Finger>& fingers) {
  std::set<int> names;
  for (Finger& finger : fingers) {
    finger.finger = named_finger(robot, finger.frames);
    finger.named = Sure::read;
    names.insert(finger.finger);
  }
  if (names.size() == fingers.size() && names.contains(0) && !names.contains(-1)) {
    std::ranges::sort(fingers, {}, &Finger::finger);
  } else {
    order_by_place(robot, fingers);
  }
}

}  // namespace

std::optional<Hand> find_hand(const Kinematics& robot, const std::string& called) {
  std::vector<int> roots;
  if (!called.empty()) {
    const auto link = robot.model->links.find(called);
    if (link == robot.model->links.end()) {
      throw InputError(
          fmt::format("{}: there is no link '{}'", robot.model->file.string(), called));
    }
    roots = {link->second};
  } else {
    find_roots(robot, 0, roots);
  }
  if (roots.empty()) return std::nullopt;
  if (roots.size() > 1) {
    std::vector<std::string> names;
    for (const int root : roots) names.push_back(robot.link[static_cast<std::size_t>(root)]);
    throw InputError(fmt::format("{}: has {} hands, at {}: name one by --hand LINK",
                                 robot.model->file.string(), roots.size(), fmt::join(names, ", ")));
  }
  Hand hand;
  hand.root = roots.front();
  for (const int leaf : below(robot, hand.root).leaves) {
    hand.fingers.push_back({0, moving_between(robot, hand.root, leaf), Sure::assumed});
  }
  if (hand.fingers.size() < 2) return std::nullopt;
  hand.gripper = one_driver(robot, hand.fingers);
  if (hand.gripper) {
    hand.fingers = gripper_ends(robot, hand.root, std::move(hand.fingers));
  } else {
    identify(robot, hand.fingers);
  }
  return hand;
}

}  // namespace morphe::setup
