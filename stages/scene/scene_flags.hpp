#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Least distance of a fingertip from where it would touch a recorded target, at the grasp, that is
/// flagged as target_offset [m]. Chosen by hand: the axis of a finger is about 11 mm from what it
/// touches, and a mean position of tips or object is rarely more than 20 mm wrong.
inline constexpr double kMaxTargetOffset_m = 0.03;
/// Least distance of a recorded object from wrist and fingertips, throughout a movement, that is
/// flagged as object_away [m]. Chosen by hand: an arm's length.
inline constexpr double kMaxObjectReach_m = 1;

/// Returns the doubts about the objects of a scene that build_scene() has returned for a movement:
///   unlikely_target  the tips hold something that is thinner, wider or taller than an inferred
///                    target may be, so that its size is a bound and not that of the thing;
///   target_offset    thumb or index closes beside the target as it was recorded; the recorded pose
///                    is used;
///   object_away      an object that was recorded is nowhere near the hand.
std::vector<RecordingFlag> scene_flags(const SceneOptions& options,
                                       const Demonstration& demonstration,
                                       const HumanMotion& motion, const Movement& movement,
                                       const Scene& scene);

}  // namespace morphe::scene
