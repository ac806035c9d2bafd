#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// Removes the spheres, boxes, cylinders and capsules of a gripper's body that contain a pad with
/// all joints at rest, at their lower or their upper limits. Some files represent the fingers in
/// all positions by such a shape, with which every grasp collides. Returns the links that lost any.
std::vector<std::string> remove_finger_placeholder_shapes(const Kinematics& robot, const Hand& hand,
                                                          const std::vector<Pad>& pads,
                                                          LinkShapes& shapes);

}  // namespace morphe::setup
