#pragma once

#include "core/motion/plan_request.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `config` violations if a plan with a trajectory differs from the request:
/// margin, max_penetration, max_link_penetration, tracking_tolerance_grasp, tracking,
/// max_unreachable_share, max_tip_error
///                    not the config's value
/// goals              frames are not spaced by the config's step; 1e-6 s
/// start_s, end_s     not the begin of the first phase and the end of the last phase to be planned;
///                    1e-9 s
/// approach, retreat  absent though requested, or present though not requested
/// OBJECT             an object of the config is missing, or has another shape, size or pose (1e-6)
/// carried            the target is attached to another frame
void verify_requirements(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs);

/// Records `robot` violations for each column in which a table differs from the requested one:
/// other names, counts or indices, or numbers that differ by more than 1e-9 of the larger of 1 and
/// their magnitude.
void verify_robot(const RobotModel& stored, const RobotModel& asked, ViolationCollector& runs);

}  // namespace morphe::verify
