#include "stages/reconstruct/skeleton_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/human/hand.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kNoLength = 1e-4;  // bones that are there in name only [m]

/// Axes of the hand in those of the wrist joint, NaN if the skeleton's hand does not show them.
Eigen::Matrix3d wrist_from_hand(const SkeletonJoint& wrist, const Digits& digits,
                                HumanMotion& motion) {
  const Eigen::Matrix3d unknown = Eigen::Matrix3d::Constant(kNotSeen);
  const SkeletonJoint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const SkeletonJoint& thumb = digits[0][0].there() ? digits[0][0] : digits[0][1];
  Vec3 to_fingers = unseen_point(), to_thumb = unseen_point();
  if (middle.there()) {
    to_fingers = mean_direction(wrist, wrist, middle);
  } else if (index.there() && little.there()) {
    to_fingers = mean_direction(wrist, wrist, index) + mean_direction(wrist, wrist, little);
  }
  if (index.there() && little.there()) {
    to_thumb = mean_direction(wrist, little, index);
  } else if (thumb.there()) {
    to_thumb = mean_direction(wrist, wrist, thumb);
  }
  if (!seen(to_fingers) || !seen(to_thumb)) {
    motion.problems.push_back(
        "the skeleton's hand has no knuckles of index, middle and little finger, nor a thumb: how "
        "the hand is turned is not known");
    return unknown;
  }
  if (!(index.there() && little.there())) {
    motion.problems.push_back(
        "the skeleton's hand has no knuckles of index and little finger: its thumb's side is where "
        "the thumb is on average");
    motion.estimated.push_back("wrist orientation");
  }
  return hand_axes(to_fingers, to_thumb);
}

/// The hand's orientation in each frame where joints have none of their own, from the same points.
std::vector<Quat> hand_from_points(const SkeletonJoint& wrist, const Digits& digits,
                                   HumanMotion& motion) {
  const SkeletonJoint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const SkeletonJoint& thumb = digits[0][0].there() ? digits[0][0] : digits[0][1];
  const bool knuckles = index.there() && little.there();
  std::vector<Quat> world_from_hand(wrist.position.size(), unseen_rotation());
  if (!knuckles && !(middle.there() && thumb.there())) {
    motion.problems.push_back(
        "the points show no knuckles of index and little finger: how the hand is turned is not "
        "known");
    return world_from_hand;
  }
  for (std::size_t i = 0; i < world_from_hand.size(); ++i) {
    const Vec3& base = wrist.position[i];
    const Vec3 to_fingers = middle.there()
                                ? Vec3(middle.position[i] - base)
                                : Vec3((index.position[i] + little.position[i]) / 2 - base);
    const Vec3 to_thumb =
        knuckles ? Vec3(index.position[i] - little.position[i]) : Vec3(thumb.position[i] - base);
    const Eigen::Matrix3d axes = hand_axes(to_fingers, to_thumb);
    if (axes.allFinite()) world_from_hand[i] = Quat(axes);
  }
  return world_from_hand;
}

}  // namespace

std::vector<Quat> hand_orientation(const std::vector<double>& time, const SkeletonJoint& hand,
                                   const SkeletonJoint& wrist, const Digits& digits,
                                   const Clock& clock, const ReconstructOptions& options,
                                   HumanMotion& motion) {
  if (is_turned(hand)) return on_clock(time, hand.orientation, clock, options);
  if (!is_turned(wrist)) {
    return on_clock(time, hand_from_points(wrist, digits, motion), clock, options);
  }
  const Eigen::Matrix3d in_wrist = wrist_from_hand(wrist, digits, motion);
  if (!in_wrist.allFinite()) return std::vector<Quat>(clock.count, unseen_rotation());
  std::vector<Quat> world_from_hand;
  for (const Quat& turn : wrist.orientation) world_from_hand.push_back(turn * Quat(in_wrist));
  return on_clock(time, world_from_hand, clock, options);
}

void estimate_tips(Digits& digits, HumanMotion& motion) {
  const RobotTable usual = human::human_hand({1, 1});
  std::vector<std::string> estimated;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    auto& [base, middle, last, tip] = digits[finger];
    if (!middle.there() || !last.there() || !tip.there()) continue;
    const double before = mean_length(middle, last);
    if (!(mean_length(last, tip) < kNoLength) || !(before > kNoLength)) continue;
    const RobotTable::Tip& model = usual.tips[finger];
    const double length =
        before * model.transform.translation().norm() /
        usual.frames[static_cast<std::size_t>(model.frame)].transform.translation().norm();
    const Vec3 along = mean_direction(middle, middle, last).normalized();
    for (std::size_t i = 0; i < tip.position.size(); ++i) {
      tip.position[i] = last.position[i] + length * (last.orientation[i] * along);
    }
    estimated.push_back(kFingerNames[finger]);
  }
  if (estimated.empty()) return;
  motion.problems.push_back(
      fmt::format("the last bones of {} have no length in the skeleton: the tips are estimated",
                  fmt::join(estimated, ", ")));
  motion.estimated.push_back("fingertips");
}

std::vector<HandKeypoints> fingers_on_clock(const std::vector<double>& time,
                                            const SkeletonJoint& wrist, const Digits& digits,
                                            const Clock& clock, const ReconstructOptions& options,
                                            const HumanMotion& motion) {
  HandKeypoints nothing;
  nothing.fill(unseen_point());
  std::vector<HandKeypoints> frames(clock.count, nothing);
  for (std::size_t i = 0; i < clock.count; ++i) frames[i][0] = motion.wrist[i];
  const std::vector<Vec3> recorded_wrist = on_clock(time, wrist.position, clock, options);
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    std::vector<Vec3> before = recorded_wrist;
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const SkeletonJoint& here = digits[finger][joint];
      if (!here.there()) continue;
      const SkeletonJoint& parent = joint == 0 ? wrist : digits[finger][joint - 1];
      const std::size_t parent_point = joint == 0 ? 0 : keypoint_of(finger, joint - 1);
      const double length = parent.there() ? mean_length(parent, here) : kNotSeen;
      std::vector<Vec3> now = on_clock(time, here.position, clock, options);
      for (std::size_t i = 0; i < clock.count; ++i) {
        frames[i][keypoint_of(finger, joint)] =
            parent.there()
                ? Vec3(frames[i][parent_point] + length * (now[i] - before[i]).normalized())
                : now[i];
      }
      before = std::move(now);
    }
  }
  return frames;
}

}  // namespace morphe::reconstruct
