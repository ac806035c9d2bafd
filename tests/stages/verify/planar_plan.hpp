#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::planar {

/// A planar arm at height 0.1 m: shoulder, elbow and a finger whose distal joint follows the
/// proximal one (angle = proximal + 0.1). Links 0.3, 0.25, 0.08, 0.06 m. Tips: index at the end of
/// the distal link; thumb on the proximal one, never seen.
RobotModel robot();

/// Where the index tip is, in closed form.
Vec3 tip_at(const Eigen::Vector3d& q);

/// Minimum jerk from (0.2, 0.5, 0.2) to (0.7, 0.9, 0.5) rad in 1 s, sampled every step_s: the
/// quintic between samples is the motion itself. The human took 0.8 s, from 2.0 s on. The distal
/// link ends 2 mm inside a sphere `cup`, 5 mm above a `table`; a `bottle` and a thin `rod` stand
/// far away.
Plan plan(double step_s = 0.01);

/// The grasp of such a plan at a sample, without contacts.
Grasp grasp_at(const Plan& plan, int sample);

Eigen::Vector3d position_at(double time_s);

}  // namespace morphe::planar
