#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// Sets the certificate's errors of forearm, swivel angle and palm: mean and maximum over the
/// trajectory's samples, against the person's at their demonstration times. A sample at which an
/// error is unknown does not count.
void set_posture_errors(const robot::Robot& robot, const Goals& goals, const Trajectory& trajectory,
                        Certificate& certificate);

}  // namespace morphe::certify
