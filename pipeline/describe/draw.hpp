#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::describe {

/// Points of what moves with a frame, in that frame: drawn as the outline of their hull.
using Outlines = std::map<int, std::vector<Vec3>>;

/// The robot from the front (y to the right, z up) and from the side (x to the right, z up) of its
/// base frame, with every joint at 0 and at 30 degrees (or as near as its limits allow), all at one
/// scale, as an SVG of its own. Capsules are drawn in their true outline, joints with
/// their names and axes, tips with the direction out of the pad. The same robot gives the same
/// text.
std::string svg_of(const RobotTable& robot, const Outlines& outlines = {});

}  // namespace morphe::describe
