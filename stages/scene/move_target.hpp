#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// A movement adapted to a different pose of its target.
struct RelocatedMovement {
  HumanMotion motion;  ///< the adapted motion
  Scene scene;         ///< with the target at its new pose
};

/// Adapts a movement to the target pose that `scene.target.pose` or `scene.target.pose_offset`
/// gives. In the world frame, with c the target's centre at the start of the grasp, d its
/// translation and R its rotation:
///   x' = R_w (x - c) + c + w d,  R_w = slerp(1, R, w),  w = 10 s³ - 15 s⁴ + 6 s⁵,
/// in which s is the share of the wrist's path length from the movement's start to the grasp's (of
/// the time, if the wrist is not seen). It is 0 and 1 at these two, so that the movement begins as
/// recorded, ends on the target as recorded, and leaves and arrives in the recorded directions.
/// From the grasp on, w = 1. Wrist, tips and finger joints are moved in this way; the shoulder
/// stays fixed. The triangle of elbow, shoulder and wrist keeps its side lengths and turns with the
/// line from shoulder to wrist by the shortest rotation; if the arm cannot reach that far, the
/// elbow is on that line. The target's whole track is moved with w = 1; the table is inferred again
/// from the moved tips. Only the movement's own frames change; arm_angles are dropped, `estimated`
/// gets "transported" and `reconstruction_notes` a sentence. The result is identical bit for bit if
/// there is no displacement.
RelocatedMovement move_target(const SceneOptions& options, const HumanMotion& motion,
                              const Movement& movement, const Scene& scene);

}  // namespace morphe::scene
