#pragma once

#include <optional>

#include "core/robot/robot.hpp"

namespace morphe::simulate {

/// Computes joint positions [rows, n] along which the palm rises by height_m along `up`, at rest at
/// both ends (minimum jerk), rotated by at most 5 degrees and displaced sideways by at most 2 mm,
/// with the arm's joints alone and within their limits. Row k is at (k + 1) / rows of the time.
/// Returns nullopt if the arm cannot execute this motion.
std::optional<JointRows> plan_lift(const robot::Robot& robot, const JointVector& from,
                                   const Vec3& up, double height_m, Eigen::Index rows);

/// Returns 10 s^3 - 15 s^4 + 6 s^5, which rises from 0 to 1 with zero velocity and acceleration at
/// both ends.
double minimum_jerk(double s);

}  // namespace morphe::simulate
