#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"

namespace morphe::scene {

/// Moves the target with thumb and index from its attach_s to its release_s (or the movement's
/// end), if it has no motion of its own. Its pose relative to the tips is that at a = attach_s:
///   world_from_object(t) = [R(t) R(a)ᵀ, m(t)] · [1, -m(a)] · world_from_object(a)
/// with m the midpoint between the two tips, and R the hand's orientation, corrected by the
/// shortest rotation that aligns the line from thumb to index (if the orientation is unknown, the
/// shortest rotation of that line alone). Thus the contact points of the tips stay fixed on the
/// object, as far as the distance between the tips is constant. Frames in which a tip is hidden are
/// interpolated. After the release the target rests. A target recorded in motion keeps that motion.
void move_with_tips(const HumanMotion& motion, const Movement& movement, SceneObject& target);

}  // namespace morphe::scene
