#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::planning {

/// Returns the mean angle [rad] between the palm of the mapped robot and the person's hand, over
/// the frames in which the hand's orientation is known; kUnknown if there are no such frames.
double palm_error(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::planning
