#pragma once

#include "core/math/quintic.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::math {

/// max(0, sqrt(slope * max(0, way left to the end)) - drop), the end being the upper one for
/// `upwards`: the speed that a braking curve leaves at q.
double speed_left(const RobotTable::BrakingCurve& curve, double q, bool upwards);

/// To which braking_ratio() is found.
inline constexpr double kBrakingResolution = 1e-6;

/// The largest speed / speed_left over a piece, to 1e-6 of it, found by bisection with bounds over
/// each interval. Infinite where the joint moves with nothing left. `known` if it is not larger.
double braking_ratio(const RobotTable::BrakingCurve& curve, const QuinticPiece& piece,
                     double known = 0);

}  // namespace morphe::math
