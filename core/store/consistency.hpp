#pragma once

#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::store {

/// Returns the first inconsistency between the arrays of a struct, that is, different lengths or
/// indices out of range, as "goals/tip_position: has 3 rows, not 4" with the path below the
/// struct's group, or "" if there is no inconsistency. It is called before writing and after
/// reading, so that no code reads out of bounds. The values of a demonstration are checked against
/// bounds (input_bounds.hpp); other values (limits, times, unit norms) are not checked.
std::string inconsistency(const Demonstration& demonstration);
/// Returns the first inconsistency of a robot.
std::string inconsistency(const RobotModel& robot);
/// Returns the first inconsistency of a plan in itself and with its robot.
std::string inconsistency(const Plan& plan, const RobotModel& robot);

}  // namespace morphe::store
