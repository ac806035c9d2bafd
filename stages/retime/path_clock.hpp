#pragma once

#include <vector>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"
#include "stages/retime/joint_spline.hpp"

namespace morphe {

/// A path with a clock that runs wherever the robot moves: the demonstration's time, except where
/// that stands still or a planned stretch would have to be faster than the joints; there a sample
/// follows the one before by the time its way takes at the joints' full speed. Long steps are
/// filled with points of the straight line, at most `step_s` apart.
struct ClockedPath {
  std::vector<double> clock;               ///< [V] from 0, not decreasing [s]
  JointRows position;                      ///< [V, n]
  std::vector<double> demonstration_time;  ///< [V] not decreasing
  std::vector<Origin> origin;              ///< [V]
  std::vector<double> stretch;  ///< [V] clock seconds per second of the clock as it was first laid
};
ClockedPath clock_path(const RobotTable& robot, const JointPath& path, double step_s);

/// The same movement along a spline through the path, on a clock that is stretched (smoothly) where
/// the spline asks for more than about `bearable` times the robot's velocity, acceleration^(1/2) or
/// jerk^(1/3): uniform knots on it resolve the sharp places. Samples lie on the spline.
ClockedPath stretch_clock(const RobotTable& robot, const ClockedPath& path,
                          const JointSpline& spline, double bearable);

/// Stretch of the clock at a clock time: linear between the samples.
double stretch_at(const ClockedPath& path, double clock);
/// Demonstration time at a clock time: linear between the samples.
double demonstration_time_at(const ClockedPath& path, double clock);
/// Origin of the nearest sample.
Origin origin_at(const ClockedPath& path, double clock);

}  // namespace morphe
