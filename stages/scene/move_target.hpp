#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// A movement as it would be with its target elsewhere.
struct MovedTarget {
  HumanMotion motion;
  Scene scene;
};

/// Transports a movement to where `scene.target.placed` or `scene.target.moved` put its target. In
/// the world frame, c the target's centre where the grasp begins, d and R its shift and turn:
///   x' = R_w (x - c) + c + w d,  R_w = slerp(1, R, w),  w = 10 s³ - 15 s⁴ + 6 s⁵,
/// s the share of the wrist's way from the movement's begin to the grasp's (of the time, if the
/// wrist is not seen): 0 and 1 at these two, so that the movement begins as it was recorded, ends
/// on the target as it did, and leaves and arrives in the recorded directions. From the grasp on
/// w = 1. Wrist, tips and finger joints are moved so; the shoulder stays; the elbow's triangle with
/// shoulder and wrist keeps its sides and turns with the line from shoulder to wrist the shortest
/// way, on that line where the arm would not reach. The target's whole track goes by w = 1; the
/// table is inferred anew from the transported tips. Only the movement's own frames change;
/// arm_angles are dropped, `estimated` gets "transported" and `problems` a sentence.
/// All stays bit for bit as it is where nothing is to be moved.
MovedTarget move_target(const SceneOptions& options, const HumanMotion& motion,
                        const Movement& movement, const Scene& scene);

}  // namespace morphe::scene
