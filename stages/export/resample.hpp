#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// Returns the trajectory at the times k / rate_hz from 0 and at its last sample, before which the
/// interval may be shorter. Position, velocity and acceleration are those of the quintic that the
/// certificate covers; demonstration time is linear between samples, and phase, origin and
/// clearance are those of the previous sample. There are at least two samples, and rate_hz > 0.
Trajectory resample(const Trajectory& trajectory, double rate_hz);

/// Returns the trajectory at the times k / rate_hz exactly, from 0 to the first one that is not
/// before its end. There the robot rests in the last posture: velocity and acceleration are zero.
/// Otherwise as resample().
Trajectory resample_uniformly(const Trajectory& trajectory, double rate_hz);

/// Returns the trajectory with `parts` - 1 points between each two samples, at equal distances on
/// the same quintics as in resample(). Its samples are kept, so that the quintics between the
/// points are those between the samples.
Trajectory subdivide(const Trajectory& trajectory, int parts);

/// Returns the trajectory, which must begin at rest, after a wait of `delay_s` in its first
/// posture; unchanged if that is not positive.
Trajectory add_initial_wait(const Trajectory& trajectory, double delay_s);

/// Returns the reason for which a trajectory cannot wait in its first posture because it moves
/// there; "" if it can.
std::string initial_motion_error(const RobotModel& robot, const Trajectory& trajectory);

/// Returns the reason for which `second` does not begin where `first` ends; "" if it does, up to
/// 1e-6 rad or m in position, 1e-5 /s in velocity and 1e-3 /s² in acceleration.
std::string continuity_error(const RobotModel& robot, const Trajectory& first,
                             const Trajectory& second);

/// Returns the motion with its end moved exactly to the begin of `next`; the small deviation
/// between them is distributed over the whole motion.
Trajectory adjust_end(const Trajectory& motion, const Trajectory& next);
/// Returns the motion with its begin moved exactly to the end of `before`, in the same way.
Trajectory adjust_begin(const Trajectory& motion, const Trajectory& before);

/// Concatenates two trajectories in continuous time. The last sample of `first` is left out in
/// favour of the first sample of `second`, which is the same.
Trajectory concatenate(const Trajectory& first, const Trajectory& second);

}  // namespace morphe::exports
