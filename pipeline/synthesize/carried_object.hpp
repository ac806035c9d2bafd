#pragma once

#include "core/motion/scene.hpp"
#include "pipeline/synthesize/motion_samples.hpp"

namespace morphe::synthesize {

/// Returns the cylinder "cup" at the samples first … last, on a clock from 0. At first it stands
/// upright between the points where thumb and index tip are as the first grasp attaches it. It is
/// fixed to the hand while a movement carries it, and rests otherwise; without a grasp its centre
/// is the origin.
SceneObject carried_object(const Script& script, const MotionSamples& samples, double height_m,
                           std::ptrdiff_t first, std::ptrdiff_t last);

}  // namespace morphe::synthesize
