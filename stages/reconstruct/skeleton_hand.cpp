#include "stages/reconstruct/skeleton_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/human/hand.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kMinBoneLength_m = 1e-4;  // length below which a bone does not exist [m]

/// Returns the axes of the hand in those of the wrist joint; NaN if the skeleton's hand does not
/// determine them.
Eigen::Matrix3d wrist_from_hand(const SkeletonJoint& wrist, const Digits& digits,
                                HumanMotion& motion) {
  const Eigen::Matrix3d unknown = Eigen::Matrix3d::Constant(kUnknown);
  const SkeletonJoint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const SkeletonJoint& thumb = digits[0][0].exists() ? digits[0][0] : digits[0][1];
  Vec3 to_fingers = unknown_point(), to_thumb = unknown_point();
  if (middle.exists()) {
    to_fingers = mean_direction(wrist, wrist, middle);
  } else if (index.exists() && little.exists()) {
    to_fingers = mean_direction(wrist, wrist, index) + mean_direction(wrist, wrist, little);
  }
  if (index.exists() && little.exists()) {
    to_thumb = mean_direction(wrist, little, index);
  } else if (thumb.exists()) {
    to_thumb = mean_direction(wrist, wrist, thumb);
  }
  if (!is_known(to_fingers) || !is_known(to_thumb)) {
    motion.reconstruction_notes.push_back(
        "the skeleton's hand has no knuckles of index, middle and little finger, nor a thumb: the "
        "orientation of the hand is unknown");
    return unknown;
  }
  if (!(index.exists() && little.exists())) {
    motion.reconstruction_notes.push_back(
        "the skeleton's hand has no knuckles of index and little finger: its thumb side is "
        "estimated from the thumb's mean position");
    motion.estimated.push_back("wrist orientation");
  }
  return hand_axes(to_fingers, to_thumb);
}

/// Returns the hand's orientation from the positions of the same points in each frame, for joints
/// without orientations.
std::vector<Quat> hand_orientation_from_points(const SkeletonJoint& wrist, const Digits& digits,
                                               HumanMotion& motion) {
  const SkeletonJoint &index = digits[1][0], &middle = digits[2][0], &little = digits[4][0];
  const SkeletonJoint& thumb = digits[0][0].exists() ? digits[0][0] : digits[0][1];
  const bool knuckles = index.exists() && little.exists();
  std::vector<Quat> world_from_hand(wrist.position.size(), unknown_rotation());
  if (!knuckles && !(middle.exists() && thumb.exists())) {
    motion.reconstruction_notes.push_back(
        "the points show no knuckles of index and little finger: the orientation of the hand is "
        "not "
        "known");
    return world_from_hand;
  }
  for (std::size_t i = 0; i < world_from_hand.size(); ++i) {
    const Vec3& base = wrist.position[i];
    const Vec3 to_fingers = middle.exists()
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
                                   const TimeGrid& clock, const ReconstructOptions& options,
                                   HumanMotion& motion) {
  if (has_orientation(hand)) return resample(time, hand.orientation, clock, options);
  if (!has_orientation(wrist)) {
    return resample(time, hand_orientation_from_points(wrist, digits, motion), clock, options);
  }
  const Eigen::Matrix3d in_wrist = wrist_from_hand(wrist, digits, motion);
  if (!in_wrist.allFinite()) return std::vector<Quat>(clock.count, unknown_rotation());
  std::vector<Quat> world_from_hand;
  for (const Quat& turn : wrist.orientation) world_from_hand.push_back(turn * Quat(in_wrist));
  return resample(time, world_from_hand, clock, options);
}

void estimate_tips(Digits& digits, HumanMotion& motion) {
  const RobotModel usual = human::human_hand({1, 1});
  std::vector<std::string> estimated;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    auto& [base, middle, last, tip] = digits[finger];
    if (!middle.exists() || !last.exists() || !tip.exists()) continue;
    const double before = mean_length(middle, last);
    if (!(mean_length(last, tip) < kMinBoneLength_m) || !(before > kMinBoneLength_m)) continue;
    const RobotModel::Tip& model = usual.tips[finger];
    const double length = before * model.transform.translation().norm() /
                          usual.frames[model.frame].transform.translation().norm();
    const Vec3 along = mean_direction(middle, middle, last).normalized();
    for (std::size_t i = 0; i < tip.position.size(); ++i) {
      tip.position[i] = last.position[i] + length * (last.orientation[i] * along);
    }
    estimated.push_back(kFingerNames[finger]);
  }
  if (estimated.empty()) return;
  motion.reconstruction_notes.push_back(
      fmt::format("the last bones of {} have no length in the skeleton: the tips are estimated",
                  fmt::join(estimated, ", ")));
  motion.estimated.push_back("fingertips");
}

std::vector<HandKeypoints> resample_fingers(const std::vector<double>& time,
                                            const SkeletonJoint& wrist, const Digits& digits,
                                            const TimeGrid& clock,
                                            const ReconstructOptions& options,
                                            const HumanMotion& motion) {
  HandKeypoints nothing;
  nothing.fill(unknown_point());
  std::vector<HandKeypoints> frames(clock.count, nothing);
  for (std::size_t i = 0; i < clock.count; ++i) frames[i][0] = motion.wrist[i];
  const std::vector<Vec3> recorded_wrist = resample(time, wrist.position, clock, options);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    std::vector<Vec3> before = recorded_wrist;
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const SkeletonJoint& here = digits[finger][joint];
      if (!here.exists()) continue;
      const SkeletonJoint& parent = joint == 0 ? wrist : digits[finger][joint - 1];
      const std::size_t parent_point = joint == 0 ? 0 : keypoint_index(finger, joint - 1);
      const double length = parent.exists() ? mean_length(parent, here) : kUnknown;
      std::vector<Vec3> now = resample(time, here.position, clock, options);
      for (std::size_t i = 0; i < clock.count; ++i) {
        frames[i][keypoint_index(finger, joint)] =
            parent.exists()
                ? Vec3(frames[i][parent_point] + length * (now[i] - before[i]).normalized())
                : now[i];
      }
      before = std::move(now);
    }
  }
  return frames;
}

}  // namespace morphe::reconstruct
