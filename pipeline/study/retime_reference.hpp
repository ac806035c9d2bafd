#pragma once

#include "stages/retime/constrained_path.hpp"

namespace morphe::study {

/// Builds the constrained path that retime() uses for the mode fastest, with the robot's full
/// limits but without jerk limits.
retime::ConstrainedPath paced_path_without_jerk(const RobotModel& robot, const JointPath& path,
                                                const Movement& movement);

/// Returns the minimum time [s] of a constrained path within velocity and acceleration limits, by
/// another method than retime(), on a grid of `steps` steps. The backward pass finds by bisection
/// the largest squared path velocity from which the remaining path can be completed. The forward
/// pass applies the largest acceleration. Constraints are evaluated at the begin of each step.
double reference_least_time_s(const retime::ConstrainedPath& path, int steps);

}  // namespace morphe::study
