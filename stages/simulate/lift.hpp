#pragma once

#include <optional>

#include "core/robot/robot.hpp"

namespace morphe::simulate {

/// Joint positions [rows, n] along which the palm rises by height_m along `up`, at rest at both
/// ends (minimum jerk), turned by no more than 5 degrees and aside by no more than 2 mm, by the
/// arm's joints alone, within their limits. Row k is at (k + 1) / rows of the time. None: the arm
/// cannot.
std::optional<JointRows> lift(const robot::Robot& robot, const JointVector& from, const Vec3& up,
                              double height_m, Eigen::Index rows);

/// 10 s^3 - 15 s^4 + 6 s^5: from 0 to 1, at rest in velocity and acceleration at both ends.
double minimum_jerk(double s);

}  // namespace morphe::simulate
