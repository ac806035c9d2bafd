#pragma once

#include <string>

#include "pipeline/motion/robot_table.hpp"
#include "pipeline/verify/verify.hpp"

namespace morphe::verify {

/// Of a violation's value and limit: m, rad, s, …; "" for a count, a share or a ratio. A joint that
/// slides has m where others have rad.
std::string unit_of(const RobotTable& robot, const Violation& violation);

}  // namespace morphe::verify
