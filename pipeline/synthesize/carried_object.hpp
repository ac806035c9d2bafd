#pragma once

#include "core/motion/scene.hpp"
#include "pipeline/synthesize/motion_samples.hpp"

namespace morphe::synthesize {

/// The upright cylinder that the first grasp closes on, between thumb and index tip, at the samples
/// [first, last]; still but while a hand carries it, when it keeps its place in the hand.
SceneObject carried_object(const Script& script, const MotionSamples& samples, double height_m,
                           std::size_t first, std::size_t last);

}  // namespace morphe::synthesize
