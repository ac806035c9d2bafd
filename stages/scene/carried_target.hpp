#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"

namespace morphe::scene {

/// Moves a target with a single recorded or inferred pose with thumb and index from its attach_s to
/// the earlier of its release_s and the movement's end; a target with more poses keeps its motion.
/// Its pose relative to the tips is that at a, the first frame from attach_s on with both tips:
///   world_from_object(t) = [R(t) R(a)ᵀ, m(t)] · [1, -m(a)] · world_from_object(a)
/// with m the midpoint between the two tips, and R the hand's orientation, corrected by the
/// shortest rotation that aligns the line from thumb to index (if the orientation is unknown, the
/// shortest rotation of that line alone). Thus the contact points of the tips stay fixed on the
/// object, as far as the distance between the tips is constant. Frames in which a tip is hidden get
/// no pose, so that they are interpolated. After the last pose the target rests.
void move_with_tips(const HumanMotion& motion, const Movement& movement, SceneObject& target);

}  // namespace morphe::scene
