#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::planning {

/// Returns the mean angle [rad] between the mapped robot's palm and the human hand, over the frames
/// in which the hand was seen; kUnknown if there are no such frames.
double palm_error(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::planning
