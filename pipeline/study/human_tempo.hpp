#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::study {

/// How a trajectory keeps the demonstration's time.
struct HumanTempo {
  double tempo = kNotSeen;        ///< its duration over the demonstration's
  double share = kNotSeen;        ///< of its time that passes within 3 % as fast as the human's
  double correlation = kNotSeen;  ///< of the tips' speeds with their goals', at the goals' instants
};

/// Speeds are central differences over two frames, then the mean over five, of both alike; all tips
/// with goals in nine frames around count.
HumanTempo human_tempo(const RobotTable& robot, const Goals& goals, const Trajectory& trajectory);

}  // namespace morphe::study
