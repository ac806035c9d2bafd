#pragma once

#include <array>

#include "core/human/arm.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::human {

/// The arm's joint centres and the hand's orientation in the world (X right, Y forward, Z up).
struct ArmPose {
  Vec3 shoulder = Vec3::Zero(), elbow = Vec3::Zero(), wrist = Vec3::Zero();
  Quat world_from_hand = Quat::Identity();  ///< hand frame of HumanMotion
};

/// kArmAngleNames [rad] of a right arm whose trunk is upright and faces Y.
using ArmAngles = std::array<double, kArmAngles>;

/// The arm that has these angles q and lengths:
///   upper arm       S = Rx(q0) Ry(-q1) Rz(q2)     elbow = shoulder - upper_arm S Z
///   forearm         F = S Rx(q3)                  wrist = elbow - forearm F Z
///   world_from_hand   = F Rz(q4) Ry(q5) Rx(q6) diag(-1, 1, -1)
/// At zero the arm hangs, the thumb to the front, the palm to the thigh. Then flexion lifts the arm
/// or forearm forward, abduction lifts the arm to the right, internal rotation and pronation turn
/// the thumb inwards, wrist flexion bends to the palm, radial deviation to the thumb.
ArmPose arm_pose(const Vec3& shoulder, const ArmLengths& lengths, const ArmAngles& angles);

/// Human joint limits [rad] of the Anthropomorphism toolbox (Barter et al. 1957). Its q3 and q5
/// turn the other way: they count external rotation and supination.
struct ArmLimits {
  ArmAngles lower, upper;
};
const ArmLimits& human_arm_limits();

/// The angles within human limits that give a pose.
struct ArmFit {
  ArmAngles angles{};
  double position_m = 0;    ///< what elbow or wrist is missed by (the larger), lengths kept
  double rotation_rad = 0;  ///< what the hand's orientation is missed by
};
/// Closed form; residual zero up to rounding for every arm_pose() within the limits. Where a pose
/// is outside, each angle in turn, from the shoulder on, is brought into its limits, and those
/// after it make up for it as far as theirs allow. What cannot be told (flexion against rotation of
/// an upper arm that points along X; rotation against pronation of a straight elbow) is split so
/// that the limits hold and the rotation is nearest zero (not both at once: an arm stretched along
/// X has flexion 0). NaN throughout if the pose has a NaN or a bone no length.
ArmFit fit_arm_angles(const ArmPose& pose);

}  // namespace morphe::human
