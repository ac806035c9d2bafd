#pragma once

#include <optional>

#include "core/robot/robot.hpp"

namespace morphe::simulate {

/// Returns joint positions [rows, n] that lift the palm from its pose at `start` by height_m along
/// the unit vector `up`, without rotation. Row k is for the share s = (k + 1) / rows of the lift's
/// time, at which the palm has risen by minimum_jerk(s) * height_m. Only the arm's joints move,
/// within their limits. Returns nullopt if the palm of any row has an error above 2 mm or 5
/// degrees.
std::optional<JointRows> plan_lift(const robot::Robot& robot, const JointVector& start,
                                   const Vec3& up, double height_m, Eigen::Index rows);

/// Returns 10 s^3 - 15 s^4 + 6 s^5: from 0 to 1, with zero velocity and acceleration at both ends.
double minimum_jerk(double s);

}  // namespace morphe::simulate
