#include "stages/reconstruct/hand_from_keypoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/reconstruct/hand_fit.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe {
namespace {

/// What the fitted hand has where its points are, in the hand frame.
HandKeypoints joints_of(const RobotTable& hand, const HandShape& shape,
                        const std::vector<Pose>& frames) {
  HandKeypoints points;
  points[0].setZero();
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    const RobotTable::Tip& tip = hand.tips[finger];
    const auto last = static_cast<std::size_t>(tip.frame);
    const auto middle = static_cast<std::size_t>(hand.frames[last].parent);
    points[keypoint_of(finger, 0)] = shape.base[finger];
    points[keypoint_of(finger, 1)] = frames[middle].translation();
    points[keypoint_of(finger, 2)] = frames[last].translation();
    points[keypoint_of(finger, 3)] = frames[last] * tip.transform.translation();
  }
  return points;
}

struct Distances {
  double squares = 0, max = 0;
  std::size_t count = 0;
  void add(double distance) {
    if (!std::isfinite(distance)) return;
    squares += distance * distance;
    max = std::max(max, distance);
    ++count;
  }
};

}  // namespace

std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length) {
  std::optional<HandShape> shape = median_hand(frames);
  if (!shape) return std::nullopt;
  FittedHand fitted;
  if (hand_length) {
    fitted.scale = *hand_length / shape->length();
    for (Vec3& base : shape->base) base *= fitted.scale;
    for (auto& bones : shape->bones) {
      for (double& bone : bones) bone *= fitted.scale;
    }
  }
  const RobotTable hand = hand_of_shape(*shape);
  HandFit fit(hand);
  fitted.angles.resize(static_cast<Eigen::Index>(frames.size()),
                       static_cast<Eigen::Index>(kHandAngles));
  fitted.joints = Table<Vec3>(frames.size(), kHandKeypoints, unseen_point());
  fitted.tip_orientation = Table<Quat>(frames.size(), kFingers, unseen_rotation());
  std::array<Distances, kFingers> missed;
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::Matrix3d axes = fit_palm(*shape, frames[i]);
    HandKeypoints in_hand;
    for (std::size_t k = 0; k < kHandKeypoints; ++k) {
      in_hand[k] = fitted.scale * axes.transpose() * (frames[i][k] - frames[i][0]);
    }
    const HandAngles angles = fit(in_hand);
    fitted.angles.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(
        angles.joint.data(), static_cast<Eigen::Index>(kHandAngles));
    const HandPoints points = hand_points(hand, angles, poses);
    const HandKeypoints joints = joints_of(hand, *shape, poses);
    for (std::size_t finger = 0; finger < kFingers; ++finger) {
      if (!seen(joints[keypoint_of(finger, 3)])) continue;
      fitted.tip_orientation(i, finger) = points.tip_orientation[finger];
      for (std::size_t joint = 0; joint < 4; ++joint) {
        const std::size_t k = keypoint_of(finger, joint);
        fitted.joints(i, k) = joints[k];
        missed[finger].add((joints[k] - in_hand[k]).norm());
      }
    }
  }
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    const auto& [squares, max, count] = missed[finger];
    if (count == 0) continue;
    fitted.residuals.push_back(
        {fmt::format("{} against a hand of constant bones", kFingerNames[finger]),
         std::sqrt(squares / static_cast<double>(count)), max});
  }
  return fitted;
}

void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const Clock& clock, const ReconstructOptions& options,
                             HumanMotion& motion) {
  std::vector<HandKeypoints> frames(clock.count);
  std::vector<Vec3> track(keypoints.time.size());
  for (std::size_t k = 0; k < kHandKeypoints; ++k) {
    for (std::size_t i = 0; i < track.size(); ++i) track[i] = keypoints.position(i, k);
    const std::vector<Vec3> on = on_clock(keypoints.time, track, clock, options);
    for (std::size_t i = 0; i < clock.count; ++i) frames[i][k] = on[i];
  }
  std::optional<FittedHand> fitted = fit_hand(frames, hand_length);
  if (!fitted) {
    motion.problems.push_back(
        "the hand's points were never all seen together: its bones are unknown");
    return;
  }
  motion.hand_angles = std::move(fitted->angles);
  motion.residuals.insert(motion.residuals.end(), fitted->residuals.begin(),
                          fitted->residuals.end());
  for (std::size_t i = 0; i < clock.count; ++i) {
    const Quat& world_from_hand = motion.wrist_orientation[i];
    for (std::size_t finger = 0; finger < kFingers; ++finger) {
      motion.tip(i, finger) =
          motion.wrist[i] + world_from_hand * fitted->joints(i, keypoint_of(finger, 3));
      motion.finger_joint(i, finger) =
          motion.wrist[i] + world_from_hand * fitted->joints(i, keypoint_of(finger, 1));
      motion.tip_orientation(i, finger) = world_from_hand * fitted->tip_orientation(i, finger);
    }
  }
}

HumanMotion motion_from_hand(const Demonstration& demonstration,
                             const ReconstructOptions& options) {
  const HandStream& hand = *demonstration.streams.hand;
  const Clock clock = clock_over({&hand.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  add_hand_from_keypoints(hand, demonstration.hand_length, clock, options, motion);
  motion.problems.push_back("the wrist was not tracked: a hand alone holds no reach");
  return motion;
}

}  // namespace morphe
