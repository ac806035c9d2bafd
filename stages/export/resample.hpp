#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// Returns the trajectory at the times k / rate_hz and at its last sample, which ends an interval
/// that may be shorter. Position, velocity and acceleration are those of the quintic that the
/// certificate covers; the phase is that of the previous sample, and demonstration time is linear
/// between samples.
Trajectory resample(const Trajectory& trajectory, double rate_hz);

/// Returns the trajectory preceded by its first posture for `delay_s`. It must begin at rest.
Trajectory add_initial_wait(const Trajectory& trajectory, double delay_s);

/// Returns the reason for which a trajectory cannot wait in its first posture because it moves
/// there; "" if it can.
std::string initial_motion_error(const RobotModel& robot, const Trajectory& trajectory);

/// Returns the reason for which one trajectory does not continue where another ends, in position,
/// velocity and acceleration; "" if it does, up to rounding.
std::string continuity_error(const RobotModel& robot, const Trajectory& first,
                             const Trajectory& second);

/// Returns the motion with its end moved exactly to the begin of `next`, distributing the small
/// deviation left by planning over the whole motion.
Trajectory adjust_end(const Trajectory& way, const Trajectory& next);
/// Returns the motion with its begin moved exactly to the end of `before`, in the same way.
Trajectory adjust_begin(const Trajectory& way, const Trajectory& before);

/// Concatenates two trajectories in continuous time; the sample that they share is that of the
/// second.
Trajectory concatenate(const Trajectory& first, const Trajectory& second);

}  // namespace morphe::exports
