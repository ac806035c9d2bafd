#pragma once

#include "core/math/quintic.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::math {

/// Returns the speed limit of a braking curve at q, max(0, sqrt(twice_deceleration * max(0,
/// distance to the end)) - velocity_offset); the end is the upper one for `upwards`.
double braking_speed_limit(const RobotModel::BrakingCurve& curve, double q, bool upwards);

/// Tolerance of braking_ratio(), relative.
inline constexpr double kBrakingRatioTolerance = 1e-6;

/// Returns the largest speed / braking_speed_limit over a piece, or `known` if that is larger, by
/// bisection with bounds over each interval; infinite if the joint moves where the limit is zero.
double braking_ratio(const RobotModel::BrakingCurve& curve, const QuinticPiece& piece,
                     double known = 0);

}  // namespace morphe::math
