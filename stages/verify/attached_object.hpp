#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// The target as an attached object. From the first sample at or after its attach_s it moves
/// rigidly with its attached_frame, up to the first sample at or after its release_s, and then
/// stays in its place. Before that it follows its recorded poses. A trajectory that ends before
/// attach_s carries no object.
struct AttachedObject {
  int object = -1, frame = -1;         ///< -1: no object is attached
  double attach_s = 0, release_s = 0;  ///< samples' demonstration times [s]
  Pose frame_from_object = Pose::Identity(), base_from_released_object = Pose::Identity();

  /// Returns true if the object is attached to the hand at a demonstration time.
  bool is_attached(double time_s) const {
    return object >= 0 && time_s >= attach_s && time_s <= release_s;
  }
  /// Returns true if the object has been released before a demonstration time.
  bool is_released(double time_s) const { return object >= 0 && time_s > release_s; }
};
/// Returns the target's attachment along a trajectory; `object` is -1 if no object is attached.
AttachedObject find_attached_object(const RobotModel& robot, const Plan& plan,
                                    const Trajectory& trajectory);

}  // namespace morphe::verify
