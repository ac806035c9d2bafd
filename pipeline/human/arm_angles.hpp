#pragma once

#include <array>

#include "pipeline/human/arm.hpp"
#include "pipeline/motion/human_motion.hpp"

namespace morphe {

/// The arm's joint centres and the hand's orientation in the world (X right, Y forward, Z up).
struct ArmPose {
  Vec3 shoulder = Vec3::Zero(), elbow = Vec3::Zero(), wrist = Vec3::Zero();
  Quat world_from_hand = Quat::Identity();  ///< hand frame of HumanMotion
};

/// kArmAngleNames [rad] of a right arm whose trunk is upright and faces Y.
using ArmAngles = std::array<double, kArmAngles>;

/// The arm that has these angles and lengths.
ArmPose arm_pose(const Vec3& shoulder, const ArmLengths& lengths, const ArmAngles& angles);

/// Human joint limits [rad] (docs: facts of the anthropomorphism toolbox).
struct ArmLimits {
  ArmAngles lower, upper;
};
ArmLimits human_arm_limits();

/// The angles within human limits that come nearest to a pose.
struct ArmFit {
  ArmAngles angles{};
  double position_m = 0;    ///< what elbow or wrist is missed by (the larger), lengths kept
  double rotation_rad = 0;  ///< what the hand's orientation is missed by
};
/// Closed form where the limits allow the pose (residual zero up to rounding for a pose of
/// arm_pose()); NaN angles if the pose has a NaN.
ArmFit fit_arm_angles(const ArmPose& pose);

}  // namespace morphe
