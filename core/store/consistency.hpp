#pragma once

#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::store {

/// Returns the first inconsistency between the arrays of a demonstration, such as different lengths
/// or an index out of range, else its first value outside of the bounds of input_bounds.hpp, "" if
/// there is neither. The text begins with the path below the struct's group: "goals/tip_position:
/// has 3 rows, not 4". The check before writing and after reading keeps code from reading out of
/// bounds. Values of robots and plans (limits, times, unit norms) are not checked.
std::string inconsistency(const Demonstration& demonstration);
/// Returns the first inconsistency of a robot.
std::string inconsistency(const RobotModel& robot);
/// Returns the first inconsistency of a plan in itself and with its robot.
std::string inconsistency(const Plan& plan, const RobotModel& robot);

}  // namespace morphe::store
