#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// The angles between a posture of the robot and the person's [rad]; NaN if unknown.
struct PostureErrors {
  double forearm = kUnknown;  ///< between the directions from elbow to wrist
  double swivel = kUnknown;   ///< of the elbow about the line from shoulder to wrist, >= 0
  double palm = kUnknown;     ///< of the rotation between the palms
};
/// Returns the errors against the person at a demonstration time, given the poses of the frames.
PostureErrors posture_errors_at(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                                const Goals& goals, double time_s);

/// Sets the certificate's errors of forearm, swivel angle and palm: mean and maximum over the
/// trajectory's samples, against the person's at their demonstration times. A sample at which an
/// error is unknown does not count.
void set_posture_errors(const robot::Robot& robot, const Goals& goals, const Trajectory& trajectory,
                        Certificate& certificate);

}  // namespace morphe::certify
