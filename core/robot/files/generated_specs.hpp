#pragma once

#include <numbers>

#include "core/motion/key_bounds.hpp"

namespace morphe::robot {

/// An arm of n joints as in the paper: n / 3 spherical joints, rounded down, each followed by a
/// link; all links have the same length. A spherical joint is three joints with intersecting axes:
/// x, y, and z along the link. If n is not a multiple of 3, the remaining joints are at the wrist
/// and rotate it about x, then y. At zero the arm points along the base's z axis.
struct ArmSpec {
  int joints = 6;                   ///< 6 … 60
  double length = 0;                ///< from the shoulder to the wrist [m]
  double limit = std::numbers::pi;  ///< range of every joint in both directions [rad]
  /// Assumed, because no such arm has been built [rad/s, rad/s^2, rad/s^3].
  double velocity = 2, acceleration = 10, jerk = 100;
  double radius = 0;  ///< of a capsule along each link; 0 for no capsules [m]
};

/// A hand of m fingers with four driven joints each: the human's thumb, and m - 1 fingers whose
/// bases, phalanges and ranges are interpolated from the human's index to little finger at equal
/// steps. If m = 5, they are the human's and called so: thumb, index … little. Else they are called
/// thumb, finger1, …, and all but the thumb have a Tip::finger_curve_share.
struct HandSpec {
  int fingers = 5;                 ///< 3 … 12, including the thumb
  double length = 0, breadth = 0;  ///< wrist to middle fingertip; across the knuckles [m]
  double velocity = 3, acceleration = 30, jerk = 300;  ///< assumed, as for the arm
  double radius = 0;  ///< of a capsule along each phalanx and metacarpal; 0 for no capsules [m]
};

/// The keys that both share.
template <class Fields, class Spec>
void add_common_fields(Fields& f, Spec& o) {
  f("velocity", o.velocity, bounds::kJointVelocity);
  f("acceleration", o.acceleration, bounds::kJointAcceleration);
  f("jerk", o.jerk, bounds::kJointJerk);
  f("radius", o.radius, bounds::kLength);
}
template <class Fields>
void fields(Fields& f, ArmSpec& o) {
  f.required("joints", o.joints, KeyBounds{6, 60});
  f.required("length", o.length, bounds::kPositiveLength);
  f("limit", o.limit, bounds::kPositiveAngle);
  add_common_fields(f, o);
}
template <class Fields>
void fields(Fields& f, HandSpec& o) {
  f.required("fingers", o.fingers, KeyBounds{3, 12});
  f.required("length", o.length, bounds::kPositiveLength);
  f.required("breadth", o.breadth, bounds::kPositiveLength);
  add_common_fields(f, o);
}

}  // namespace morphe::robot
