#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The limits of a joint that a description adds to its URDF.
struct JointLimits {
  std::string joint;                             ///< its name
  std::optional<double> lower, upper, velocity;  ///< [rad or m, /s]; unset if the URDF has them
  bool position_given = false;                   ///< true if a person gave lower and upper
  double motor_velocity = 0;  ///< of the URDF, if it was not believed [rad/s or m/s]
  bool prismatic = false;
  double acceleration = 0, jerk = 0;
  std::optional<RobotModel::BrakingCurve> braking;  ///< if one is published
  Provenance sure = Provenance::assumed;
  std::string source;  ///< publisher of the limits, "" if they are not published
};

/// Returns the limits of every actuated joint: those published for the robot, otherwise
///   acceleration = 3 / s * velocity, jerk = 50 / s * acceleration.
/// No published table (Franka Panda and Research 3, KUKA iiwa, Kinova Gen3) is below these, except
/// for the wrist of the Research 3. A velocity that is 0 or missing in the URDF becomes 1 rad/s or
/// 0.1 m/s; one that is only reached by a motor without load (kMaxBelievedVelocity_rad_s) becomes
/// 3.14 rad/s or 0.1 m/s. `given` are limits of position that replace those of the URDF.
std::vector<JointLimits> joint_limits(const Kinematics& robot, const robot::GivenLimits& given);

/// Returns the joints that the URDF locks by equal limits, without those that a person freed.
std::vector<std::string> locked_joints(const robot::UrdfModel& model);

/// Returns sentences on the limits that are assumed for these joints, and on joints that the URDF
/// locks, each with the way to answer.
std::vector<std::string> limit_items(const robot::UrdfModel& model,
                                     const std::vector<JointLimits>& limits,
                                     const std::set<std::string>& joints);

}  // namespace morphe::setup
