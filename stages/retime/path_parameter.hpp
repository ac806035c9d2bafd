#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::retime {

/// A path with a path parameter (its clock) that increases wherever the robot moves. It is the
/// demonstration time, except where that stands still or a planned interval would exceed the
/// joints' full speed; there each sample follows the previous one by the time that the motion takes
/// at the joints' full speed. Long steps are filled with points of the straight line, at most
/// `step_s` apart.
struct ParameterizedPath {
  std::vector<double> parameter;           ///< [V] nondecreasing from 0 [s]
  JointRows position;                      ///< [V, n]
  std::vector<double> demonstration_time;  ///< [V] nondecreasing
  std::vector<SampleOrigin> origin;        ///< [V]
};
/// Parameterises a path. With `keep_pauses` false, an interval slower than 2 % of the joints' full
/// speed takes as long as at 2 %, and one without motion takes no time.
ParameterizedPath parameterize_path(const RobotModel& robot, const JointPath& path, double step_s,
                                    bool keep_pauses);

/// Returns the demonstration time at a path parameter, linear between the samples.
double demonstration_time_at(const ParameterizedPath& path, double clock);
/// Returns the origin of the nearest sample.
SampleOrigin origin_at(const ParameterizedPath& path, double clock);

}  // namespace morphe::retime
