#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::study {

/// The agreement of a trajectory's timing with the demonstration.
struct TimingScore {
  double duration_ratio = kUnknown;     ///< duration divided by that of the demonstration
  double human_speed_share = kUnknown;  ///< share of the samples within 3 % of the human's tempo
  double correlation = kUnknown;        ///< of the tips' speeds with those of their goals
};

/// Computes the agreement; it is unknown for fewer than two samples or frames. Speeds of tips and
/// goals are central differences over two frames, followed by a mean over five. Speeds for which a
/// goal is unknown in one of the seven frames involved are left out.
TimingScore score_timing(const RobotModel& robot, const Goals& goals, const Trajectory& trajectory);

}  // namespace morphe::study
