#pragma once

#include "pipeline/humanlike/loads.hpp"
#include "pipeline/humanlike/robot_state.hpp"

namespace morphe::humanlike {

/// weight * ‖reference - s_j‖², divided by the number of centres of the same chain.
void add_centre(const RobotState& state, const RobotTable::Centre& centre, const Vec3& reference,
                double weight, Loads& loads);

}  // namespace morphe::humanlike
