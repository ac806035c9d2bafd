#pragma once

#include <string>

#include "core/motion/robot_table.hpp"
#include "stages/verify/violation.hpp"

namespace morphe::verify {

/// Of a violation's value and limit: m, rad, s, …; "" for a count, a share or a ratio. A joint that
/// slides has m where others have rad.
std::string unit_of(const RobotTable& robot, const Violation& violation);

}  // namespace morphe::verify
