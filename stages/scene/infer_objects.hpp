#pragma once

#include <optional>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Tolerance within which a frame is at the border of an interval [s].
inline constexpr double kTimeTolerance_s = 1e-9;

/// Infers the box "table" with its top at `height`, or at
///   min(percentile of all tip heights, lowest planned tip) − tip_clearance.
/// Returns no object if it is disabled, or if no tip is seen and no height is given.
std::optional<SceneObject> infer_table(const TableOptions& options, const HumanMotion& motion,
                                       const Movement& movement);

/// The mean thumb and index tips over the second half of the grasp, in which the hand has closed;
/// if a tip is hidden then, over the whole grasp, or over that and the preceding 0.1 s. NaN if it
/// is not seen then either.
struct GraspTips {
  Vec3 thumb, index;  ///< in the world [m]
};
/// Computes the mean tips at the grasp.
GraspTips tips_at_grasp(const HumanMotion& motion, const Phase& grasp);

/// Sets attach_s and release_s: from the end of the grasp to the end of the last transport (or of
/// the movement, if there is no transport).
void set_attachment_times(const Movement& movement, const Phase& grasp, SceneObject& target);

/// Infers the target: the cylinder between the tips, or options.body, placed on `table` (without a
/// table, centred at the height of the tips). Returns no object if a tip was not seen.
std::optional<SceneObject> infer_target(const TargetOptions& options, const HumanMotion& motion,
                                        const Movement& movement, const SceneObject* table);

}  // namespace morphe::scene
