#include "stages/reconstruct/hand_from_keypoints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/rotation.hpp"
#include "stages/reconstruct/finger_ik_solver.hpp"
#include "stages/reconstruct/residual_sum.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kMaxJointSpeed_rad_s = 30;

bool is_any_seen(const HandKeypoints& points) {
  return std::ranges::any_of(points, [](const Vec3& point) { return is_known(point); });
}

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
  ResidualSum shifts;
  std::array<ResidualSum, kFingerCount> misfits;
  std::vector<Pose> poses;
  for (int i = 0; i < std::ssize(frames); ++i) {
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
      shifts.add((joints[k] - in_hand[k]).norm());
    }
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      if (!is_known(points.tip[finger])) continue;
      const auto joint = [&](std::size_t k) { return joints[keypoint_index(finger, k)]; };
      misfits[finger].add((points.tip[finger] - joint(3)).norm());
      misfits[finger].add((points.middle_joint[finger] - joint(1)).norm());
      const Quat& model = points.tip_orientation[finger];
      const Quat bend = math::shortest_rotation(model * Vec3::UnitZ(), joint(3) - joint(2));
      fitted.tip_orientation(i, finger) = (bend * model).normalized();
    }
  }
  shifts.report("keypoints, bones constant", fitted.residuals);
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    misfits[finger].report(fmt::format("hand angles, {}", kFingerNames[finger]), fitted.residuals);
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

void set_finger_points(const std::vector<HandKeypoints>& frames, HumanMotion& motion) {
  for (int i = 0; i < std::ssize(frames); ++i) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      motion.tip(i, finger) = frames[i][keypoint_index(finger, 3)];
      motion.finger_joint(i, finger) = frames[i][keypoint_index(finger, 1)];
    }
  }
}

void set_tip_orientations(const FittedHand& fitted, HumanMotion& motion) {
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      motion.tip_orientation(i, finger) =
          motion.wrist_orientation[i] * fitted.tip_orientation(i, finger);
    }
  }
}

void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const TimeGrid& clock, const ReconstructOptions& options,
                             HumanMotion& motion) {
  std::vector<HandKeypoints> frames(clock.count);
  std::vector<Vec3> track(keypoints.time.size());
  for (std::size_t k = 0; k < kHandKeypoints; ++k) {
    for (int i = 0; i < std::ssize(track); ++i) track[i] = keypoints.position(i, k);
    const std::vector<Vec3> resampled = resample(keypoints.time, track, clock, options);
    for (int i = 0; i < clock.count; ++i) frames[i][k] = resampled[i];
  }
  const std::optional<FittedHand> fitted = fit_hand(frames, hand_length, clock.rate_hz);
  if (!fitted) {
    motion.reconstruction_notes.push_back(
        std::ranges::none_of(frames, is_any_seen)
            ? fmt::format("the hand was never seen twice within reconstruct.max_gap_s ({} s): it "
                          "cannot be reconstructed",
                          options.max_gap_s)
            : "the hand's points were never all seen together: the lengths of its bones are "
              "unknown");
    return;
  }
  add_hand_angles(*fitted, motion);
  motion.bones = fitted->bones;
  for (int i = 0; i < clock.count; ++i) {
    for (std::size_t k = 0; k < kHandKeypoints; ++k) {
      frames[i][k] = motion.wrist[i] + motion.wrist_orientation[i] * fitted->joints(i, k);
    }
  }
  set_finger_points(frames, motion);
  set_tip_orientations(*fitted, motion);
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
