#pragma once

#include <optional>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::simulate {

/// A load on the target while it is carried as planned: acceleration of gravity less that of the
/// target's centre, in the target's frame [m/s^2].
using CarriedLoad = Vec3;

/// The part of a plan that carries its target; times since the trajectory's start. The planned
/// poses of the target are those that planning and certificate assume (core/collision).
struct PlannedTask {
  double release_s = 0;  ///< the hand releases the target, or the trajectory ends
  bool lets_go = false;  ///< true if the trajectory goes on after the release
  Pose base_from_placed = Pose::Identity();  ///< pose of the target at the release
  double rise_m = 0;                         ///< greatest rise of its lowest point
  std::vector<CarriedLoad> loads;            ///< at least one
};

/// Returns the task of a plan in which a transport begins before the trajectory ends, for a robot
/// with an arm; nullopt for other plans. The grasp ends at sample `grasp_end`; `up` is the world's
/// vertical in the base frame.
std::optional<PlannedTask> planned_task(const robot::Robot& robot, const Plan& plan,
                                        Eigen::Index grasp_end, const Vec3& up);

}  // namespace morphe::simulate
