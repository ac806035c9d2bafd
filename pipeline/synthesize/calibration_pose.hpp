#pragma once

#include "pipeline/synthesize/simulated_glove.hpp"
#include "pipeline/synthesize/simulated_sensors.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Simulates the static recording before the movements: the arm in the state `resting` with the
/// wrist straight and the hand flat. It contains the sensors with their noise, the glove with its
/// noise and bias, and as markers the digitised points shoulder, elbow, wrist and three knuckles,
/// one row for each time that they are digitised.
Streams simulate_calibration(const SynthesizeOptions& options, const Subject& subject,
                             const ArmState& resting, const SensorMounts& mounts,
                             const GloveBias& bias, math::RandomStream& random);

}  // namespace morphe::synthesize
