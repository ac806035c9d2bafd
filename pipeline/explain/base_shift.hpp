#pragma once

#include <optional>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::explain {

/// A shift of the base that would make an infeasible movement easier.
struct BaseShift {
  Vec3 shift = Vec3::Zero();  ///< shift of the base, along the world's axes [m]
  /// depths of the findings of single postures, summed, before and after the shift [m or rad]
  double depth_before = 0, depth_after = 0;
  std::size_t frames = 0;  ///< number of frames evaluated
};

/// Returns the shift |s_k| <= limit_m (by a compass search down to 10 mm) that minimises
///   sum over frames of depths(best posture) + 0.01 |s|.
/// The frames are those around the findings that repair has left and a few along the movement; the
/// best posture results from solves with tips and clearance only, starting from the postures of the
/// path and of the mapping. The shift is computed from the plan alone: the goals of tips and the
/// scene move relative to the base, the arm's goals stay. Returns nullopt if the plan was not
/// mapped, the target is attached in all of these frames, or no shift halves the sum.
std::optional<BaseShift> find_base_shift(const robot::Robot& robot,
                                         const planning::PipelineConfig& config, const Plan& plan,
                                         double limit_m);

}  // namespace morphe::explain
