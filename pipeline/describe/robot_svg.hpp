#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::describe {

/// For each frame, points of the bodies fixed to it, in that frame. Their convex hull is drawn.
using Outlines = std::map<int, std::vector<Vec3>>;

/// Returns two drawings of the robot at one scale, as a self-contained SVG: from the front (y to
/// the right, z up) and from the side (x to the right, z up) of its base frame, with every joint at
/// 0 or as near as its limits allow. Chains are coloured by role; joints, joint centres, the palm
/// and tips are marked, with their names beside the drawing; capsules have their true outline.
std::string robot_svg(const RobotModel& robot, const Outlines& outlines = {});

}  // namespace morphe::describe
