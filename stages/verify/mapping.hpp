#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `mapped` violations for frames whose values disagree with their posture and goals, once
/// each, at the worst frame: position_error [m], orientation_error [rad] and the sum A of
/// humanlikeness, to 1e-6; status, from the tips within 1 mm of their goals and the reachability
/// stored in the file; position if frames are missing or values are not finite. The objective and
/// the terms B and C depend on the mapping's internals and only have to be numbers.
void verify_mapping(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
