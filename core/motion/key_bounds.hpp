#pragma once

#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// The permitted values of a numeric key of a YAML file: lower <= value <= upper, or < where an end
/// is open. Every numeric key states them once, where it is declared (fields(), the readers of
/// robot descriptions); the readers, the schemas and the validation of programs take them from
/// there.
struct KeyBounds {
  double lower = 0, upper = 0;
  const char* unit = "";
  bool lower_open = false, upper_open = false;
  const char* reason = "";  ///< for a user who needs another value, as " (…)"

  /// Returns true if the value is permitted; NaN is not.
  constexpr bool contain(double value) const {
    return (lower_open ? value > lower : value >= lower) &&
           (upper_open ? value < upper : value <= upper);
  }
  /// Returns the same bounds without their lower end.
  constexpr KeyBounds above_lower() const { return {lower, upper, unit, true, upper_open, reason}; }
  /// Returns the same bounds without their upper end.
  constexpr KeyBounds below_upper() const { return {lower, upper, unit, lower_open, true, reason}; }
  /// Returns the bounds with another upper end.
  constexpr KeyBounds up_to(double value) const {
    return {lower, value, unit, lower_open, false, reason};
  }
  /// Returns the bounds with another lower end.
  constexpr KeyBounds from(double value) const {
    return {value, upper, unit, false, upper_open, reason};
  }
};

/// Returns the bounds in words: "above 0 and at most 10 m".
MORPHE_EXPORT std::string text_of(const KeyBounds& bounds);

/// Bounds by kind of quantity, which no laboratory with a human arm and a robot exceeds. They
/// exclude values in another unit and those with which a computation overflows or does not end.
namespace bounds {

/// Lengths and distances: no robot, table or person is larger; millimetres exceed it.
inline constexpr KeyBounds kLength{0, 10, "m"};
inline constexpr KeyBounds kPositiveLength = kLength.above_lower();
inline constexpr KeyBounds kSignedLength = kLength.from(-10);
/// Sizes of objects of the scene, of which a floor is the largest.
inline constexpr KeyBounds kObjectSize{0, 100, "m", true};
/// Coordinates: the largest room with a tracking system; millimetres exceed it.
inline constexpr KeyBounds kCoordinate{-20, 20, "m"};
/// Angles and joint positions: 16 turns; degrees without their unit exceed it soon.
inline constexpr KeyBounds kAngle{-100, 100, "rad"};
inline constexpr KeyBounds kAngleSize = kAngle.from(0);
inline constexpr KeyBounds kPositiveAngle = kAngleSize.above_lower();
/// A joint's position, in rad, or in m if it slides.
inline constexpr KeyBounds kJointPosition{-100, 100, "rad"};
/// Times: an hour is longer than any movement.
inline constexpr KeyBounds kDuration{0, 3600, "s"};
inline constexpr KeyBounds kPositiveDuration = kDuration.above_lower();
/// Widths of a smoothing over time: what is longer than a second leaves nothing of a reach.
inline constexpr KeyBounds kSmoothing{0, 1, "s"};
/// Times on the clock of a recording, which may count from any year.
inline constexpr KeyBounds kClockTime{-1e12, 1e12, "s"};
/// Steps of a grid over a movement: a finer one has more frames than memory.
inline constexpr KeyBounds kTimeStep{1e-3, 10, "s"};
/// Rates of recordings and controllers.
inline constexpr KeyBounds kRate{0, 1e4, "Hz", true};
/// Limits of joints, of which "no limit" is written as a large number.
inline constexpr KeyBounds kJointVelocity{0, 1e6, "rad/s", true};
inline constexpr KeyBounds kJointAcceleration{0, 1e9, "rad/s^2", true};
inline constexpr KeyBounds kJointJerk{0, 1e12, "rad/s^3", true};
inline constexpr KeyBounds kSpeedOffset = kJointVelocity.from(0);
/// Speeds of a point of the robot or the person.
inline constexpr KeyBounds kSpeed{1e-3, 100, "m/s"};
inline constexpr KeyBounds kShare{0, 1};
inline constexpr KeyBounds kPositiveShare = kShare.above_lower();
inline constexpr KeyBounds kShareBelow1 = kShare.below_upper();
/// Factors and ratios between two sizes.
inline constexpr KeyBounds kFactor{1e-3, 1000};
inline constexpr KeyBounds kFactorFrom1 = kFactor.from(1);
inline constexpr KeyBounds kFactorOrNone = kFactor.from(0);
/// Ratios of coupled joints, of either sign.
inline constexpr KeyBounds kCoupling{-1000, 1000};
/// Units of a mesh file's coordinates in m.
inline constexpr KeyBounds kMeshScale{1e-6, 1000};
inline constexpr KeyBounds kPercentile{0, 100};
/// Weights in an objective: beside a weight of 1e9, doubles lose what other terms say.
inline constexpr KeyBounds kWeight{0, 1e9};
/// Relative tolerances of a solver.
inline constexpr KeyBounds kTolerance{0, 1};
/// Components of a unit vector or quaternion, with rounding.
inline constexpr KeyBounds kUnit{-1.001, 1.001};
/// Mechanics: no arm lifts a ton; the friction of rubber is below 4.
inline constexpr KeyBounds kMass{0, 1000, "kg", true};
inline constexpr KeyBounds kForce{0, 1e5, "N", true};
inline constexpr KeyBounds kTorque{0, 1e5, "N m", true};
inline constexpr KeyBounds kStiffness{0, 1e9, "N m/rad", true};
inline constexpr KeyBounds kGain{0, 1e9};
inline constexpr KeyBounds kFriction{0, 10};
/// Numbers of things that are computed one by one; more of them never end.
inline constexpr KeyBounds kCount{1, 1e6};
inline constexpr KeyBounds kCountOrNone = kCount.from(0);
/// Numbers of searches, each of which takes a part of a second.
inline constexpr KeyBounds kSearchCount{1, 1e4};
inline constexpr KeyBounds kSearchCountOrNone = kSearchCount.from(0);
/// Lengths of a bone of the arm or the hand.
inline constexpr KeyBounds kBone{0, 3, "m", true};
/// Extents of an inferred target, chosen by hand: what is thinner is pinched and does not stand by
/// itself, and nothing taller than a bottle is held by its side. What is grasped higher above the
/// table is not taken from it, like a comb at the head.
inline constexpr const char* kNotInferred = " as an inferred target is; else give its body";
inline constexpr KeyBounds kInferredExtent{0.03, 0.3, "m", false, false, kNotInferred};
inline constexpr KeyBounds kInferredRadius{0.015, 0.15, "m", false, false, kNotInferred};

}  // namespace bounds
}  // namespace morphe
