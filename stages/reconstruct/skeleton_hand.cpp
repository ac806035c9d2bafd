#include "stages/reconstruct/skeleton_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <tuple>

#include "core/human/hand.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kMinBoneLength_m = 1e-4;  ///< below it a bone does not exist

/// Returns the joints of thumb, index, middle and little finger that show the axes of the hand.
auto knuckles_of(const Digits& digits) {
  return std::tie(digits[kThumb][digits[kThumb][0].exists() ? 0 : 1], digits[kIndex][0],
                  digits[kMiddle][0], digits[kLittle][0]);
}

/// Returns the axes of the hand in those of the wrist joint; NaN if the joints do not show them.
Eigen::Matrix3d wrist_from_hand(const SkeletonJoint& wrist, const Digits& digits,
                                HumanMotion& motion) {
  const auto& [thumb, index, middle, little] = knuckles_of(digits);
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
    return Eigen::Matrix3d::Constant(kUnknown);
  }
  if (!(index.exists() && little.exists())) {
    motion.reconstruction_notes.push_back(
        "the skeleton's hand has no knuckles of index and little finger: its thumb side is "
        "estimated from the thumb's mean position");
    motion.estimated.push_back("wrist orientation");
  }
  return hand_axes(to_fingers, to_thumb);
}

/// Returns the hand's orientation from positions frame by frame, for joints without orientations.
std::vector<Quat> hand_orientation_from_points(const SkeletonJoint& wrist, const Digits& digits,
                                               HumanMotion& motion) {
  const auto& [thumb, index, middle, little] = knuckles_of(digits);
  const bool knuckles = index.exists() && little.exists();
  std::vector<Quat> world_from_hand(wrist.position.size(), unknown_rotation());
  if (!knuckles && !(middle.exists() && thumb.exists())) {
    motion.reconstruction_notes.push_back(
        "the points show no knuckles of index and little finger: the orientation of the hand is "
        "not known");
    return world_from_hand;
  }
  for (int i = 0; i < std::ssize(world_from_hand); ++i) {
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
  for (const Quat& q : wrist.orientation) world_from_hand.push_back(q * Quat(in_wrist));
  return resample(time, world_from_hand, clock, options);
}

void estimate_tips(Digits& digits, HumanMotion& motion) {
  const RobotModel average = human::human_hand({1, 1});
  std::vector<std::string> estimated;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    auto& [base, middle, last, tip] = digits[finger];
    if (!middle.exists() || !last.exists() || !tip.exists()) continue;
    const double before = mean_length(middle, last);
    if (!(mean_length(last, tip) < kMinBoneLength_m) || !(before > kMinBoneLength_m)) continue;
    const RobotModel::Tip& model = average.tips[finger];
    const double length = before * model.transform.translation().norm() /
                          average.frames[model.frame].transform.translation().norm();
    const Vec3 along = mean_direction(middle, middle, last).normalized();
    for (int i = 0; i < std::ssize(tip.position); ++i) {
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
  HandKeypoints unseen;
  unseen.fill(unknown_point());
  std::vector<HandKeypoints> frames(clock.count, unseen);
  for (int i = 0; i < clock.count; ++i) frames[i][0] = motion.wrist[i];
  const std::vector<Vec3> recorded_wrist = resample(time, wrist.position, clock, options);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    std::vector<Vec3> parent_position = recorded_wrist;
    for (int k = 0; k < 4; ++k) {
      const SkeletonJoint& joint = digits[finger][k];
      const SkeletonJoint& parent = k == 0 ? wrist : digits[finger][k - 1];
      if (!joint.exists()) continue;
      const std::size_t parent_point = k == 0 ? 0 : keypoint_index(finger, k - 1);
      const double length = parent.exists() ? mean_length(parent, joint) : kUnknown;
      std::vector<Vec3> position = resample(time, joint.position, clock, options);
      for (int i = 0; i < clock.count; ++i) {
        const Vec3 bone = length * (position[i] - parent_position[i]).normalized();
        frames[i][keypoint_index(finger, k)] =
            parent.exists() ? Vec3(frames[i][parent_point] + bone) : position[i];
      }
      parent_position = std::move(position);
    }
  }
  return frames;
}

}  // namespace morphe::reconstruct
