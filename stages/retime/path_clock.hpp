#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::retime {

/// A path with a clock that runs wherever the robot moves: the demonstration's time, except where
/// that stands still or a planned stretch would have to be faster than the joints; there a sample
/// follows the one before by the time its way takes at the joints' full speed. Long steps are
/// filled with points of the straight line, at most `step_s` apart.
struct ClockedPath {
  std::vector<double> clock;               ///< [V] from 0, not decreasing [s]
  JointRows position;                      ///< [V, n]
  std::vector<double> demonstration_time;  ///< [V] not decreasing
  std::vector<Origin> origin;              ///< [V]
};
/// `keep_pauses` false: a stretch slower than 2 % of the joints' full speed takes as long as at 2
/// %, one that stands still no time at all.
ClockedPath clock_path(const RobotTable& robot, const JointPath& path, double step_s,
                       bool keep_pauses);

/// Demonstration time at a clock time: linear between the samples.
double demonstration_time_at(const ClockedPath& path, double clock);
/// Origin of the nearest sample.
Origin origin_at(const ClockedPath& path, double clock);

}  // namespace morphe::retime
