#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `path` for a path that does not lead from the mapped frames to the trajectory:
/// demonstration_time  runs back, or does not begin and end with the goals; 1e-9 s
/// position            no numbers; of origin mapped, and not what was mapped for its time; 1e-9 rad
/// trajectory          a sample is more than 0.2 rad (0.1 m, where a joint slides) outside of what
///                     the path does around its time: what smoothing may do lies far within
/// origin              a sample of the trajectory has an origin that the path has not around its
/// time
void judge_path(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
