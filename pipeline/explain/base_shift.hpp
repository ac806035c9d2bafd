#pragma once

#include <optional>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::explain {

/// A shift of the base that would make an infeasible movement easier.
struct BaseShift {
  Vec3 shift = Vec3::Zero();                 ///< along the world's axes [m]
  double depth_before = 0, depth_after = 0;  ///< sum of the excess of single postures [m]
  std::size_t frames = 0;                    ///< number of frames evaluated
};

/// Returns the shift s, |s_k| <= limit_m, that minimises
///   (sum over frames of the summed excess of the best posture's findings) + 0.01 |s|
/// by a compass search with steps down to 10 mm. The frames are the middles of the worst findings
/// that repair has left, and a few along the movement. The best posture is that with less excess of
/// two, solved from the path and from the mapping with tips and clearance only. The goals of tips
/// and the scene move relative to the base, the arm's goals stay. Returns nullopt if the plan was
/// not mapped, the target is attached in all of these frames, or no shift halves the sum.
std::optional<BaseShift> find_base_shift(const robot::Robot& robot,
                                         const planning::PipelineConfig& config, const Plan& plan,
                                         double limit_m);

}  // namespace morphe::explain
