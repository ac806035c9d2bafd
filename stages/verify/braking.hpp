#pragma once

#include "core/motion/robot_table.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// Where a joint is fastest for what a braking curve leaves it there.
struct BrakingUse {
  double ratio = 0;  ///< speed / what is left, infinite where it moves and nothing is
  double s = 0, speed = 0, left = 0;
};

/// The greatest over the piece, to 1e-6 of it: on a part of it no ratio exceeds the greatest speed
/// there over the least that is left, nor that in its middle by more than its steepest change, and
/// parts are halved until that settles it. Parts that cannot exceed `known` are not looked into;
/// what 2000 halvings have not settled is as bad as it may be.
BrakingUse worst_braking(const RobotTable::BrakingCurve& curve, const Quintic& quintic,
                         double known);

}  // namespace morphe::verify
