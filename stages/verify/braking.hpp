#pragma once

#include "core/motion/robot_model.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// The point at which a joint's speed is largest relative to the speed its braking curve allows.
struct BrakingLimitUse {
  double ratio = 0;  ///< speed / allowed speed; infinite if the joint moves and no speed is allowed
  double s = 0, speed = 0, allowed_speed = 0;  ///< at s in [0, 1] of the piece [rad/s]
};

/// Returns the largest ratio over the piece, to 1e-6 of it. On any part of the piece the ratio
/// exceeds neither the greatest speed divided by the least allowed speed, nor its value in the
/// middle by more than its greatest rate of change permits; parts are bisected until these bounds
/// decide. Parts that cannot exceed `known` are skipped; for parts that are undecided after 2000
/// bisections the upper bound is returned.
BrakingLimitUse max_braking_use(const RobotModel::BrakingCurve& curve, const Quintic& quintic,
                                double known);

}  // namespace morphe::verify
