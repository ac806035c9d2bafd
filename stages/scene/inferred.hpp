#pragma once

#include <optional>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Frames this near to a border are on it [s].
inline constexpr double kTimeSlack = 1e-9;

/// The box "table": top at `height`, or
///   min(percentile of all tip heights, lowest planned tip) − tip_clearance.
/// Nothing if it is switched off, or no tip is seen and no height is given.
std::optional<SceneObject> infer_table(const TableOptions& options, const HumanMotion& motion,
                                       const Movement& movement);

/// Mean thumb and index tips over the second half of the grasp, when the hand has closed; over the
/// whole grasp, or that and the 0.1 s before it, if one is hidden. NaN where it is not seen then.
struct GraspTips {
  Vec3 thumb, index;
};
GraspTips tips_at_grasp(const HumanMotion& motion, const Phase& grasp);

/// attach_s and release_s: from the end of the grasp to the end of the last transport (of the
/// movement, if there is none).
void set_carrying(const Movement& movement, const Phase& grasp, SceneObject& target);

/// The cylinder between the tips, or options.body, standing on `table` (without one: centred at
/// their height). Nothing if a tip was not seen.
std::optional<SceneObject> infer_target(const TargetOptions& options, const HumanMotion& motion,
                                        const Movement& movement, const SceneObject* table);

}  // namespace morphe::scene
