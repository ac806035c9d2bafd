#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/hand_frames.hpp"
#include "pipeline/setup/shapes.hpp"

namespace morphe::setup {

/// Some files give a gripper's body a shape that stands for the fingers wherever they are: no grasp
/// would be free of it. Takes out its balls, boxes, cylinders and capsules in which a pad lies
/// at some opening. The links they belonged to, each once.
std::vector<std::string> take_out_finger_space(const Kinematics& robot, const Hand& hand,
                                               const std::vector<Pad>& pads, LinkShapes& shapes);

}  // namespace morphe::setup
