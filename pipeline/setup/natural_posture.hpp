#pragma once

#include <vector>

#include "core/robot/files/description.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Returns the natural posture of fingers without a goal: joints that bend a finger (axes nearly
/// parallel to the last) follow those of the index, counted from the tip; others stay at rest, so
/// that fingers do not spread. Empty for a gripper and for less than three fingers.
std::vector<robot::NaturalJoint> natural_posture(const Kinematics& robot, const Hand& hand);

}  // namespace morphe::setup
