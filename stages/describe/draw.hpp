#pragma once

#include <string>

#include "pipeline/motion/robot_table.hpp"

namespace morphe::describe {

/// The robot from the front (y to the right, z up) and from the side (x to the right, z up) of its
/// base frame, with every joint at 0 and at 30 degrees (or as near as its limits allow), all at one
/// scale, as an SVG of its own. Capsules are drawn in their true outline. The same robot
/// gives the same text.
std::string svg_of(const RobotTable& robot);

}  // namespace morphe::describe
