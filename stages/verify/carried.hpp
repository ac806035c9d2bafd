#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::verify {

/// The target in the hand: from the first sample at or after its attach_s it moves with its
/// attached_frame as it lay there, to the first sample at or after its release_s, where it stays.
/// Before, it is where it was recorded. A trajectory that ends by then carries nothing.
struct Carried {
  int object = -1, frame = -1;  ///< -1: nothing is carried
  double begin_s = 0, end_s = 0;
  Pose frame_from_object = Pose::Identity(), base_from_released = Pose::Identity();

  bool in_hand(double time_s) const { return object >= 0 && time_s >= begin_s && time_s <= end_s; }
  bool released(double time_s) const { return object >= 0 && time_s > end_s; }
};
Carried carried_target(const RobotTable& robot, const Plan& plan, const Trajectory& trajectory);

}  // namespace morphe::verify
