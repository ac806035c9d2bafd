#include "stages/reconstruct/hand_from_keypoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/rotation.hpp"
#include "stages/reconstruct/finger_ik_solver.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kMaxJointSpeed_rad_s = 30;  // of a finger's joint [rad/s]

bool seen_point(const Vec3& point) { return is_known(point); }

struct ResidualAccumulator {
  double squares = 0, max = 0;
  std::size_t count = 0;
  void add(double distance) {
    if (!std::isfinite(distance)) return;
    squares += distance * distance;
    max = std::max(max, distance);
    ++count;
  }
  void report(const std::string& name, std::vector<Residual>& residuals) const {
    if (count > 0)
      residuals.push_back({name, std::sqrt(squares / static_cast<double>(count)), max});
  }
};

}  // namespace

std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length, double rate_hz) {
  std::optional<HandShape> shape = estimate_hand_shape(frames);
  if (!shape) return std::nullopt;
  const double scale = hand_length ? *hand_length / shape->length() : 1;
  for (Vec3& base : shape->base) base *= scale;
  for (auto& bones : shape->bone_lengths) {
    for (double& bone : bones) bone *= scale;
  }
  const RobotModel hand = make_hand_model(*shape);
  FingerIkSolver fit(hand, kMaxJointSpeed_rad_s / rate_hz);
  FittedHand fitted;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const auto& bones = shape->bone_lengths[finger];
    fitted.bones.knuckle[finger] = shape->base[finger];
    fitted.bones.length[finger] = bones[0] + bones[1] + bones[2];
  }
  fitted.thumb_base_estimated = shape->thumb_base_estimated;
  fitted.angles.resize(frames.size(), kHandAngleCount);
  fitted.joints = Array2D<Vec3>(frames.size(), kHandKeypoints, unknown_point());
  fitted.tip_orientation = Array2D<Quat>(frames.size(), kFingerCount, unknown_rotation());
  ResidualAccumulator moved;
  std::array<ResidualAccumulator, kFingerCount> missed;
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::Matrix3d axes = fit_palm(*shape, frames[i]);
    HandKeypoints in_hand;
    for (std::size_t k = 0; k < kHandKeypoints; ++k) {
      in_hand[k] = scale * axes.transpose() * (frames[i][k] - frames[i][0]);
    }
    const HandKeypoints joints = enforce_finger_lengths(*shape, in_hand);
    const human::HandAngles angles = fit(joints);
    fitted.angles.row(i) =
        Eigen::Map<const Eigen::RowVectorXd>(angles.joint.data(), kHandAngleCount);
    const human::HandPoints points = human::hand_points(hand, angles, poses);
    for (std::size_t k = 0; is_known(in_hand[0]) && k < kHandKeypoints; ++k) {
      fitted.joints(i, k) = joints[k];
      moved.add((joints[k] - in_hand[k]).norm());
    }
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      const Vec3& tip = joints[keypoint_index(finger, 3)];
      if (!is_known(points.tip[finger])) continue;
      missed[finger].add((points.tip[finger] - tip).norm());
      missed[finger].add((points.middle_joint[finger] - joints[keypoint_index(finger, 1)]).norm());
      const Quat& modelled = points.tip_orientation[finger];
      fitted.tip_orientation(i, finger) =
          (math::shortest_rotation(modelled * Vec3::UnitZ(),
                                   tip - joints[keypoint_index(finger, 2)]) *
           modelled)
              .normalized();
    }
  }
  moved.report("keypoints, bones constant", fitted.residuals);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    missed[finger].report(fmt::format("hand angles, {}", kFingerNames[finger]), fitted.residuals);
  }
  return fitted;
}

void add_hand_angles(const FittedHand& fitted, HumanMotion& motion) {
  motion.hand_angles = fitted.angles;
  motion.residuals.insert(motion.residuals.end(), fitted.residuals.begin(), fitted.residuals.end());
  if (!fitted.thumb_base_estimated) return;
  motion.estimated.emplace_back("thumb base");
  motion.reconstruction_notes.emplace_back(
      "the thumb's base (CMC) was not recorded: estimated from the proportions of a hand (error "
      "usually below 20 mm); the thumb's angles and the roll of its tip depend on it");
}

void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const TimeGrid& clock, const ReconstructOptions& options,
                             HumanMotion& motion) {
  std::vector<HandKeypoints> frames(clock.count);
  std::vector<Vec3> track(keypoints.time.size());
  for (std::size_t k = 0; k < kHandKeypoints; ++k) {
    for (std::size_t i = 0; i < track.size(); ++i) track[i] = keypoints.position(i, k);
    const std::vector<Vec3> on = resample(keypoints.time, track, clock, options);
    for (std::size_t i = 0; i < clock.count; ++i) frames[i][k] = on[i];
  }
  const std::optional<FittedHand> fitted = fit_hand(frames, hand_length, clock.rate_hz);
  if (!fitted) {
    const bool nothing = std::ranges::none_of(frames, [](const HandKeypoints& points) {
      return std::ranges::any_of(points, seen_point);
    });
    motion.reconstruction_notes.push_back(
        nothing ? fmt::format("the hand was never seen twice within reconstruct.max_gap_s ({} s): "
                              "it cannot be reconstructed",
                              options.max_gap_s)
                : "the hand's points were never all seen together: the lengths of its bones are "
                  "unknown");
    return;
  }
  add_hand_angles(*fitted, motion);
  motion.bones = fitted->bones;
  for (std::size_t i = 0; i < clock.count; ++i) {
    const Quat& world_from_hand = motion.wrist_orientation[i];
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      motion.tip(i, finger) =
          motion.wrist[i] + world_from_hand * fitted->joints(i, keypoint_index(finger, 3));
      motion.finger_joint(i, finger) =
          motion.wrist[i] + world_from_hand * fitted->joints(i, keypoint_index(finger, 1));
      motion.tip_orientation(i, finger) = world_from_hand * fitted->tip_orientation(i, finger);
    }
  }
}

HumanMotion motion_from_hand(const Demonstration& demonstration,
                             const ReconstructOptions& options) {
  const HandStream& hand = *demonstration.streams.hand;
  const TimeGrid clock = make_time_grid({&hand.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  add_hand_from_keypoints(hand, demonstration.hand_length, clock, options, motion);
  motion.reconstruction_notes.push_back(
      "the wrist was not tracked: a reach cannot be found without it");
  return motion;
}

}  // namespace morphe::reconstruct
