#pragma once

#include "core/motion/robot_model.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// The instant at which a joint's speed is largest relative to the speed its braking curve allows.
struct BrakingLimitUse {
  double ratio = 0;  ///< speed / allowed speed; infinite if the joint moves and no speed is allowed
  double s = 0, speed = 0, allowed_speed = 0;  ///< at s in [0, 1] of the piece [rad/s]
};

/// Returns the largest ratio over the piece, to 1e-6 of it; `known_ratio` if no other is larger.
/// Two bounds hold on any part of the piece: the greatest speed divided by the least allowed speed,
/// and the ratio in the middle plus its greatest rate of change times half the duration. Parts are
/// bisected until these bounds decide. After 2000 bisections the upper bound is returned.
BrakingLimitUse max_braking_use(const RobotModel::BrakingCurve& curve, const Quintic& quintic,
                                double known_ratio);

}  // namespace morphe::verify
