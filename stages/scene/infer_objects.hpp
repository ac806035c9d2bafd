#pragma once

#include <optional>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Tolerance within which a frame is at the border of an interval [s].
inline constexpr double kTimeTolerance_s = 1e-9;

/// Infers the box "table" with its top at `height`, or at
///   min(resting height of the tips, lowest tip within the movement) − tip_clearance.
/// Returns no object if the table is disabled, or if no tip is seen and no height is given.
std::optional<SceneObject> infer_table(const TableOptions& options, const HumanMotion& motion,
                                       const Movement& movement);

/// The tips of thumb and index finger at a grasp, in the world [m]; NaN if not seen.
struct GraspTips {
  Vec3 thumb, index;
};
/// Returns the mean positions of the tips over the second half of the grasp, in which the hand has
/// closed. For a tip that is hidden then, it is the mean over the whole grasp; if it is hidden then
/// too, over the grasp and the preceding 0.1 s.
GraspTips tips_at_grasp(const HumanMotion& motion, const Phase& grasp);

/// Returns the horizontal distance of thumb and index [m].
double horizontal_aperture(const GraspTips& tips);
/// Returns the radius of a cylinder that fits between thumb and index, without bounds [m]; < 0 if
/// they are nearer to each other than their pads are thick.
double radius_between(const TargetOptions& options, const GraspTips& tips);
/// Returns the height of the rim that an inferred target needs in the world [m].
double rim_height(const TargetOptions& options, const GraspTips& tips);
/// Returns the height of a table's top in the world [m].
double table_top_height(const SceneObject& table);

/// Sets attach_s and release_s: from the end of the grasp to the end of the last transport (or of
/// the movement, if there is no transport).
void set_attachment_times(const Movement& movement, const Phase& grasp, SceneObject& target);

/// Infers the target: the cylinder between the tips, or options.body, placed on `table`. If that is
/// null, or so far below that the cylinder would be higher than bounds::kInferredExtent, the
/// cylinder is centred at the height of the tips. Returns no object if options.infer is false, the
/// movement has no grasp, or a tip was not seen.
std::optional<SceneObject> infer_target(const TargetOptions& options, const HumanMotion& motion,
                                        const Movement& movement, const SceneObject* table);

}  // namespace morphe::scene
