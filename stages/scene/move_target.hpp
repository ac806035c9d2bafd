#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// A movement adapted to a different pose of its target.
struct RelocatedMovement {
  HumanMotion motion;
  Scene scene;  ///< with the target at its new pose
};

/// Adapts a movement to the target pose that `scene.target.pose` or `scene.target.pose_offset`
/// gives. In the world frame, with c the target's recorded centre at the start of the grasp, and d
/// and R the translation and the rotation of the target, a point x moves to
///   x' = R_w (x - c) + c + w d,  R_w = slerp(1, R, w),  w = 10 s³ - 15 s⁴ + 6 s⁵,
/// in which s is the share of the wrist's path from the movement's begin to the grasp's begin that
/// has been travelled (of the time, if the wrist is not seen). At the first, w = 0; from the second
/// on, w = 1. Thus the movement begins as recorded, ends on the target as recorded, and leaves and
/// arrives in the recorded directions.
///   Wrist, tips and finger joints move in this way. The shoulder stays fixed. Upper arm and
///   forearm keep their lengths, and the elbow turns with the line from shoulder to wrist by the
///   shortest rotation; if the wrist is too far away, the elbow is on that line. All poses of the
///   target move with w = 1. The table is inferred again from the moved tips.
/// Frames before the movement's begin and after its end do not change. arm_angles are dropped,
/// `estimated` gets "transported" and `reconstruction_notes` a sentence. Without a displacement the
/// result is identical bit for bit; without a grasp or a target, it has only another note.
RelocatedMovement move_target(const SceneOptions& options, const HumanMotion& motion,
                              const Movement& movement, const Scene& scene);

}  // namespace morphe::scene
