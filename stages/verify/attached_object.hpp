#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// The target as an attached object. It follows its recorded poses up to the attach sample, the
/// first one at or after the target's attach_s. It then moves rigidly with its attached_frame up to
/// the release sample, the first one at or after its release_s, and stays in place from there on.
struct AttachedObject {
  int object = -1, frame = -1;         ///< object -1: no object is attached
  double attach_s = 0, release_s = 0;  ///< demonstration times of the two samples
  Pose frame_from_object = Pose::Identity(), base_from_released_object = Pose::Identity();

  /// Returns true if the object is attached to the hand at a demonstration time.
  bool is_attached(double time_s) const {
    return object >= 0 && time_s >= attach_s && time_s <= release_s;
  }
  /// Returns true if the object has been released before a demonstration time.
  bool is_released(double time_s) const { return object >= 0 && time_s > release_s; }
};
/// Returns the target's attachment along a trajectory. No object is attached without attach_s or a
/// known frame, or if the attach sample is missing or at the end of the trajectory.
AttachedObject find_attached_object(const RobotModel& robot, const Plan& plan,
                                    const Trajectory& trajectory);

}  // namespace morphe::verify
