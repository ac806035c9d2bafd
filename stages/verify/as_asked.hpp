#pragma once

#include "core/motion/asked.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `config` where a plan with a trajectory is not what was asked for:
/// margin, contact_depth, link_depth, tracking_grasp, tracking, out_of_reach_share, farthest_tip
///                    other than the config's
/// goals              frames that are not the config's step apart; 1e-6 s
/// start_s, end_s     other than where the first phase begins and the last that is to be planned
///                    ends; 1e-9 s
/// approach, retreat  missing or there, other than asked for
/// OBJECT             of the config: missing, or of another shape, size or place (1e-6)
/// carried            the frame that carries the target is another
void judge_as_asked(const Plan& plan, const Asked& asked, ViolationRuns& runs);

/// Notes `robot` for each column in which a table is not the one that was asked for: other names,
/// counts or indices, or numbers off by more than 1e-9 of 1 or of their size.
void judge_robot(const RobotTable& stored, const RobotTable& asked, ViolationRuns& runs);

}  // namespace morphe::verify
