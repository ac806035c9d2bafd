#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The limits of a joint that a description adds to its URDF.
struct JointLimits {
  std::string joint;                             ///< its name
  std::optional<double> lower, upper, velocity;  ///< [rad or m, /s]; unset if the URDF has them
  double acceleration = 0, jerk = 0;
  std::optional<RobotModel::BrakingCurve> braking;  ///< if one is published
  Provenance sure = Provenance::assumed;
  std::string source;  ///< publisher of the limits, "" if they are not published
};

/// Returns the limits of every actuated joint: those published for the robot, otherwise
///   acceleration = 3 / s * velocity, jerk = 50 / s * acceleration.
/// No published table (Franka Panda and Research 3, KUKA iiwa, Kinova Gen3) is below these, except
/// for the wrist of the Research 3. A velocity missing in the URDF becomes 1 rad/s or 0.1 m/s.
std::vector<JointLimits> joint_limits(const Kinematics& robot);

}  // namespace morphe::setup
