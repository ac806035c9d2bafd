#pragma once

#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::store {

/// What keeps the arrays of a struct from fitting together: lengths that differ, indices out of
/// range. "goals/tip_position: has 3 rows, not 4" with the path below the struct's group, "" if
/// all is well. Asked before writing and after reading, so that nobody reads beyond an end. Of a
/// demonstration's values it is judged whether they can be worked on (workable.hpp); others
/// (limits, times, unit norms) are not.
std::string inconsistency(const Demonstration& demonstration);
std::string inconsistency(const RobotTable& robot);
std::string inconsistency(const Plan& plan, const RobotTable& robot);

}  // namespace morphe::store
