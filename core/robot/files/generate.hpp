#pragma once

#include <numbers>
#include <string>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// An arm of n joints as in the paper: n / 3 spherical joints (three intersecting axes, about x, y
/// and z of the preceding link; z along the following link) and as many links of equal length. If n
/// is not a multiple of 3, the remaining joints are at the tip and rotate it about x, then y. At
/// zero the arm points along the base's z axis.
struct ArmSpec {
  int joints = 6;                   ///< 6 … 60
  double length = 0;                ///< from the shoulder to the wrist [m]
  double limit = std::numbers::pi;  ///< range of every joint in both directions [rad]
  /// Assumed, because no such arm has been built; only for time parametrisation [rad/s], [rad/s^2],
  /// [rad/s^3].
  double velocity = 2, acceleration = 10, jerk = 100;
  double radius = 0;  ///< of a capsule along each link; 0 for no capsules [m]
};

/// A hand of m fingers: the human's thumb, and m - 1 fingers between the human's index and little
/// finger, with bases, phalanges and ranges interpolated at equal steps (for m = 5 they equal the
/// human hand's). Each finger has four driven joints. Fingers are called thumb, index … little if m
/// = 5, else thumb, finger1, …, and these have a parameter along the curve of fingertips.
struct HandSpec {
  int fingers = 5;                 ///< 3 … 12, including the thumb
  double length = 0, breadth = 0;  ///< wrist to middle fingertip; across the knuckles [m]
  double velocity = 3, acceleration = 30, jerk = 300;  ///< assumed, as for the arm
  /// Radius of a capsule along each phalanx and each metacarpal (those of the fingers belong to the
  /// palm); 0 for no capsules [m].
  double radius = 0;
};

/// Returns a description of the error in a specification, or "" if it is valid.
std::string validation_error(const ArmSpec& shape);
/// Returns a description of the error in a specification, or "" if it is valid.
std::string validation_error(const HandSpec& shape);

/// Generates an arm. Its chain is called `arm` and its wrist is the end effector. The specification
/// must pass validation_error().
RobotModel generate_arm(const ArmSpec& shape);
/// Generates a hand. Its base is its palm. The specification must pass validation_error().
RobotModel generate_hand(const HandSpec& shape);
/// Generates the hand mounted on the arm, with wrist_from_palm relative to the frame at the arm's
/// end.
RobotModel generate_arm_hand(const ArmSpec& arm, const HandSpec& hand,
                             const Pose& wrist_from_palm = Pose::Identity());

}  // namespace morphe::robot
