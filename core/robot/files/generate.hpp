#pragma once

#include "core/motion/robot_model.hpp"
#include "core/robot/files/generated_specs.hpp"

namespace morphe::robot {

/// Generates an arm. Its chain is called `arm`; its wrist serves as palm frame and as only tip.
/// Its values must be within their bounds.
RobotModel generate_arm(const ArmSpec& shape);
/// Generates a hand, whose base is its palm. Its values must be within their bounds.
RobotModel generate_hand(const HandSpec& shape);
/// Generates an arm with a hand, whose palm has the pose `wrist_from_palm` in the arm's wrist
/// frame. The values of both must be within their bounds.
RobotModel generate_arm_hand(const ArmSpec& arm, const HandSpec& hand,
                             const Pose& wrist_from_palm = Pose::Identity());

}  // namespace morphe::robot
