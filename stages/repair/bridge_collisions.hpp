#pragma once

#include "core/motion/robot_model.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::repair {

/// Returns the path with a straight line over each of its collisions: the joints of the fingers
/// that collide move linearly from their positions `margin_s` before the collision to those
/// `margin_s` after it. A collision at an end of the path is bridged by the positions on its other
/// side. Bridges that overlap are joined, joint by joint. A finger consists of the joints below the
/// frame at which it leaves the palm; collisions of other bodies, and those that leave no sample to
/// begin from, are not bridged. Bridged samples have the origin `re_solved`.
JointPath bridge_collisions(const RobotModel& robot, const CheckedPath& checked, double margin_s);

}  // namespace morphe::repair
