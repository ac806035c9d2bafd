#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"

namespace morphe::verify {

/// Recomputes the certificate's errors of forearm, swivel angle and palm at the samples, and the
/// correlation of the wrist's speeds, as docs/steps/certify.md defines them.
void recompute_posture(const RobotModel& robot, const Plan& plan, const Curve& curve,
                       Certificate& own);

}  // namespace morphe::verify
