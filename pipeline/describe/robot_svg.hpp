#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::describe {

/// The points of the bodies fixed to each frame, in that frame. They are drawn as the outline of
/// their convex hull.
using Outlines = std::map<int, std::vector<Vec3>>;

/// Draws the robot from the front (y to the right, z up) and from the side (x to the right, z up)
/// of its base frame, with every joint at 0 and at 30 degrees (or as near as its limits allow), all
/// at one scale, as a self-contained SVG. Capsules are drawn in their true outline, joints with
/// their names and axes, tips with the direction out of the pad. Equal robots give equal texts.
std::string robot_svg(const RobotModel& robot, const Outlines& outlines = {});

}  // namespace morphe::describe
