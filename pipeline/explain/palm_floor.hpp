#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// Mean angles of the postures with the tips where they are driven, within the joint limits,
/// without obstacles, at which the squares of the three angles have the least sum that two local
/// searches find [rad].
struct WholeArmFloor {
  double upper_arm = kUnknown, forearm = kUnknown, palm = kUnknown;
};

/// Mean angles between palm and the person's hand over a few samples of a trajectory [rad]; NaN
/// without fingers' goals, a trajectory, or an arm.
struct PalmFloor {
  double driven = kUnknown;  ///< as driven
  /// Least angle found with the tips where they are driven, by two local searches, within the joint
  /// limits, without obstacles: by all joints, and by the fingers' joints alone with a palm that
  /// may be anywhere. The true least angles are at most these.
  double whole_robot = kUnknown, hand_alone = kUnknown;
  WholeArmFloor whole_arm = {};
};
/// Computes the angles at up to 16 evenly spaced samples.
PalmFloor palm_floor(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
