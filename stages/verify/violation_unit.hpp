#pragma once

#include <string>

#include "core/motion/robot_model.hpp"
#include "stages/verify/violation.hpp"

namespace morphe::verify {

/// Returns the unit of a violation's value and limit: m, rad, s, …; "" for a count, a share or a
/// ratio, and for causes whose values differ in unit. A prismatic joint has m instead of rad.
std::string unit_of(const RobotModel& robot, const Violation& violation);

}  // namespace morphe::verify
