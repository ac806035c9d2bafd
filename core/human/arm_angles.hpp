#pragma once

#include <array>

#include "core/human/arm.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::human {

/// The arm's joint centres and the hand's orientation in the world (X right, Y forward, Z up).
struct ArmPose {
  Vec3 shoulder = Vec3::Zero(), elbow = Vec3::Zero(), wrist = Vec3::Zero();
  Quat world_from_hand = Quat::Identity();  ///< rotation of HumanMotion's hand frame
};

/// The angles kArmAngleNames [rad] of a right arm of a person who is upright and faces Y.
using ArmAngles = std::array<double, kArmAngleCount>;

/// Computes the pose of an arm with the angles q and these lengths:
///   upper arm       S = Rx(q0) Ry(-q1) Rz(q2)     elbow = shoulder - upper_arm S Z
///   forearm         F = S Rx(q3)                  wrist = elbow - forearm F Z
///   world_from_hand   = F Rz(q4) Ry(q5) Rx(q6) diag(-1, 1, -1)
/// At zero the arm hangs down, with the thumb to the front and the palm to the thigh. Flexion lifts
/// the arm or forearm forward, abduction lifts the arm to the right, internal rotation and
/// pronation rotate the thumb inwards, wrist flexion bends towards the palm, radial deviation
/// towards the thumb.
ArmPose arm_pose(const Vec3& shoulder, const ArmLengths& lengths, const ArmAngles& angles);

/// Human joint limits [rad] of the Anthropomorphism toolbox (Barter et al. 1957). The signs of
/// rotation and pronation are changed: the toolbox counts external rotation and supination.
struct ArmLimits {
  ArmAngles lower, upper;
};
/// Returns the human joint limits of the arm.
const ArmLimits& human_arm_limits();

/// The angles within human limits that fit a pose, and the remaining errors.
struct ArmFit {
  ArmAngles angles{};
  double position_error_m = 0;    ///< the larger one of elbow and wrist
  double rotation_error_rad = 0;  ///< of the hand's orientation
};
/// Fits the angles in closed form. The errors are zero up to rounding for every arm_pose() within
/// the limits. For other poses, each angle in turn, from the shoulder on, is clamped to its limits,
/// and the following angles compensate for it as far as theirs allow. Two pairs of angles can be
/// determined only together: flexion and rotation of an upper arm along X, rotation and pronation
/// of a straight elbow. They are distributed within their limits such that the rotation is nearest
/// to zero. An arm stretched along X gets flexion 0, although the other limits may then leave an
/// error. All values are NaN if the pose contains a NaN or a segment of length zero.
ArmFit fit_arm_angles(const ArmPose& pose);

}  // namespace morphe::human
