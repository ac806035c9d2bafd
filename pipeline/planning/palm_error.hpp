#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::planning {

/// Mean angle [rad] between the mapped robot's palm and the human hand, over the frames in which
/// the hand was seen; kNotSeen if none.
double palm_error(const RobotTable& robot, const Plan& plan);

}  // namespace morphe::planning
