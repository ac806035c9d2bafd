#pragma once

#include "core/math/quintic.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::math {

/// Returns the speed limit of a braking curve at q, max(0, sqrt(slope * max(0, distance to the
/// end)) - drop); the end is the upper one for `upwards`.
double braking_speed_limit(const RobotModel::BrakingCurve& curve, double q, bool upwards);

/// Tolerance of braking_ratio().
inline constexpr double kBrakingRatioTolerance = 1e-6;

/// Returns the largest speed / braking_speed_limit over a piece, to 1e-6 of it, found by bisection
/// with bounds over each interval. It is infinite if the joint moves with a limit of zero. Returns
/// `known` if the ratio is not larger.
double braking_ratio(const RobotModel::BrakingCurve& curve, const QuinticPiece& piece,
                     double known = 0);

}  // namespace morphe::math
