#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::retime {

/// A path with a path parameter (its clock) that increases wherever the robot moves. The parameter
/// advances with the demonstration time, but by at least the time of a planned step at the joints'
/// full speed, or of a recorded one at kMaxRecordedSpeedRatio times that. Long steps are filled
/// with points of the straight line.
struct ParameterizedPath {
  std::vector<double> parameter;           ///< [V] nondecreasing from 0 [s]
  JointRows position;                      ///< [V, n]
  std::vector<double> demonstration_time;  ///< [V] nondecreasing
  std::vector<SampleOrigin> origin;        ///< [V]
};
/// Parameterises a path of at least one sample, with steps of at most `step_s`. Without
/// `keep_pauses`, a step advances at most by its time at kPauseSpeedRatio of full speed.
ParameterizedPath parameterize_path(const RobotModel& robot, const JointPath& path, double step_s,
                                    bool keep_pauses);

/// Returns the demonstration time at a path parameter, linear between the samples.
double demonstration_time_at(const ParameterizedPath& path, double clock);
/// Returns the origin of the sample nearest to a path parameter.
SampleOrigin origin_at(const ParameterizedPath& path, double clock);

}  // namespace morphe::retime
