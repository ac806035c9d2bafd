#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// The contacts that count: their pads are at most 2 mm from the surface. [rows of Grasp::contacts]
std::vector<std::size_t> contacts_that_touch(const Grasp& grasp);

/// Notes `quality` for what the plan's contacts do not bear out (judge_grasp_contacts() must have
/// found them as they are):
/// friction, torsion, mass    below 0, or not what the config says (where that can be read)
/// centre, torque_scale       not those of the target's shape; 1e-6 m
/// epsilon_lower              above an upper bound that was found; epsilon_upper below a lower one
///                            (wrench_bounds.hpp)
/// epsilon                    the two bounds are farther apart than 5 % or 1e-3
/// needed_worst, needed_down  less than an upper bound of the weight that can be borne lets it be;
///                            or more than 5 % (and 2e-3 of that weight) above what a lower one
///                            asks
/// given                      not the config's joint_torque over the largest lever of the contact
///                            for which that is largest; 1e-6 of it
/// With fewer than two contacts that touch each of the last six must be none.
void judge_grasp_quality(const RobotTable& robot, const Plan& plan, const std::string& config,
                         ViolationRuns& runs);

}  // namespace morphe::verify
