#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"

namespace morphe::scene {

/// Gives the target, if it has no motion of its own, the one that thumb and index carry it with
/// from its attach_s to its release_s (or the movement's end), as it lay between them at attach_s:
///   world_from_object(t) = [R(t) R(a)ᵀ, m(t)] · [1, -m(a)] · world_from_object(a)
/// m half-way between the two tips; R the hand's orientation, turned the least that the line from
/// thumb to index needs to fit (without it: that line's least turn alone). So the tips stay where
/// they were on the object, as far as they keep their distance. Frames in which a tip is hidden are
/// bridged. Then it stays where it is. One recorded in motion keeps that motion.
void carry_between_tips(const HumanMotion& motion, const Movement& movement, SceneObject& target);

}  // namespace morphe::scene
