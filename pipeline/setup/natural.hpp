#pragma once

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// What fingers do that have no goal: bend as the index does, joint by joint from the tip on, and
/// do not spread. The hinges that bend are those along the last one's axis.
std::vector<robot::NaturalJoint> natural_posture(const Kinematics& robot, const Hand& hand);

}  // namespace morphe::setup
