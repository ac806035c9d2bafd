#pragma once

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Returns the natural posture of fingers without a goal: they bend as the index does, joint by
/// joint from the tip on, and do not spread. The bending hinges are those along the axis of the
/// last one.
std::vector<robot::NaturalJoint> natural_posture(const Kinematics& robot, const Hand& hand);

}  // namespace morphe::setup
