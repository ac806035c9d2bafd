#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::study {

/// The agreement of a trajectory's timing with the demonstration.
struct TimingScore {
  /// Duration divided by that of the demonstration.
  double duration_ratio = kUnknown;
  /// Share of time in which the pace is within 3 % of the human's.
  double human_speed_share = kUnknown;
  /// Correlation of the speeds of the tips with those of their goals, at the instants of the goals.
  double correlation = kUnknown;
};

/// Computes the agreement. Speeds are central differences over two frames, followed by a mean over
/// five, for both series; all tips with goals in nine surrounding frames are included.
TimingScore score_timing(const RobotModel& robot, const Goals& goals, const Trajectory& trajectory);

}  // namespace morphe::study
