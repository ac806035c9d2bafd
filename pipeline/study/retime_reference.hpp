#pragma once

#include "stages/retime/paced_path.hpp"

namespace morphe::study {

/// A course through a path as retime() makes it for the mode fastest, with the robot's whole limits
/// but no jerk's.
retime::PacedPath plain_course(const RobotTable& robot, const JointPath& path,
                               const Movement& movement);

/// The least time of a course within velocity and acceleration limits, by another method on `steps`
/// steps: backwards, the largest x that the rest can be reached from, by bisection (either some
/// acceleration is left at x or none is); forwards, the largest acceleration. Constraints at the
/// near end of each step alone. [s]
double reference_time(const retime::PacedPath& course, int steps);

}  // namespace morphe::study
