#pragma once

#include <optional>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::explain {

/// Where else the base would have to stand for a movement that is infeasible.
struct BaseShift {
  Vec3 shift = Vec3::Zero();     ///< of the base, along the world's axes [m]
  double before = 0, after = 0;  ///< depths of what single postures have wrong, summed [m or rad]
  std::size_t frames = 0;        ///< that were looked at
};

/// The shift |s_k| <= limit_m (a compass search down to 10 mm) that makes
///   sum over frames of depths(best posture) + 0.01 |s|
/// least: frames around what repair has left and a few along the movement, the best posture by
/// solves with tips and freedom alone from those of the path and of the mapping. From the plan
/// alone: goals of tips and the scene move against the base, the arm's stay. None: nothing was
/// mapped, the target is in the hand in all of these frames, or no shift makes it half as bad.
std::optional<BaseShift> find_base_shift(const robot::Robot& robot,
                                         const planning::PipelineConfig& config, const Plan& plan,
                                         double limit_m);

}  // namespace morphe::explain
