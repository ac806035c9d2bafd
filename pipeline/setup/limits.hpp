#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The limits of a joint that a description adds to its URDF; empty values are those that the URDF
/// contains.
struct JointLimits {
  /// The name of the joint.
  std::string joint;
  /// The position limits [rad or m] and the velocity limit [rad/s or m/s].
  std::optional<double> lower, upper, velocity;
  /// The acceleration and jerk limits.
  double acceleration = 0, jerk = 0;
  /// The braking curve, if one is published.
  std::optional<RobotModel::BrakingCurve> braking;
  /// The certainty of the limits.
  Provenance sure = Provenance::assumed;
  /// Publisher of the limits, "" if they are not published.
  std::string source;
};

/// Returns the limits of every actuated joint. Robots with published limits are given those;
/// otherwise
///   acceleration = 3 / s velocity, jerk = 50 / s acceleration,
/// which no published table (Franka Panda and Research 3, KUKA iiwa, Kinova Gen3) falls below,
/// except for the wrist of the Research 3. The velocity is 1 rad/s or 0.1 m/s if the URDF has no
/// velocity.
std::vector<JointLimits> joint_limits(const Kinematics& robot);

}  // namespace morphe::setup
