#pragma once

#include "pipeline/synthesize/simulated_glove.hpp"
#include "pipeline/synthesize/simulated_sensors.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Simulates the static recording before the movements: the arm at rest, wrist straight, hand flat.
/// It contains the sensors with their noise, the glove with its noise and bias, and the digitised
/// points shoulder, elbow, wrist, index_mcp, middle_mcp, little_mcp as markers, with a row for each
/// time they were touched.
Streams simulate_calibration(const SynthesizeOptions& options, const Subject& subject,
                             const ArmState& resting, const SensorMounts& mounts,
                             const GloveBias& bias, math::RandomStream& random);

}  // namespace morphe::synthesize
