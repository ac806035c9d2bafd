#pragma once

#include "core/motion/scene.hpp"
#include "pipeline/synthesize/motion_samples.hpp"

namespace morphe::synthesize {

/// Returns the upright cylinder that the first grasp closes on, between thumb and index tip, at the
/// samples [first, last]. It is stationary except while a hand carries it, when it keeps its pose
/// relative to the hand.
SceneObject carried_object(const Script& script, const MotionSamples& samples, double height_m,
                           std::size_t first, std::size_t last);

}  // namespace morphe::synthesize
