#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// What a description says of a joint beside its URDF; nothing where that says it.
struct JointLimits {
  std::string joint;
  std::optional<double> lower, upper, velocity;
  double acceleration = 0, jerk = 0;
  std::optional<RobotTable::BrakingCurve> braking;
  Sure sure = Sure::assumed;
  std::string source;  ///< "" or who published it
};

/// Of every joint that drives. Robots whose limits are published have those; else
///   acceleration = 3 / s velocity, jerk = 50 / s acceleration,
/// which no published table (Franka Panda and Research 3, KUKA iiwa, Kinova Gen3) falls below but
/// for the wrist of the Research 3. A URDF without velocity: 1 rad/s, 0.1 m/s.
std::vector<JointLimits> joint_limits(const Kinematics& robot);

}  // namespace morphe::setup
