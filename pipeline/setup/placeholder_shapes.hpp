#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// Removes placeholder shapes of fingers. Some files give the body of a gripper a shape that
/// represents the fingers in all positions, so that no grasp would be free of collision. The
/// function removes the spheres, boxes, cylinders and capsules that contain a pad at some opening.
/// Returns the links of the removed shapes, each once.
std::vector<std::string> remove_finger_placeholder_shapes(const Kinematics& robot, const Hand& hand,
                                                          const std::vector<Pad>& pads,
                                                          LinkShapes& shapes);

}  // namespace morphe::setup
