#pragma once

#include <array>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/motion_samples.hpp"
#include "pipeline/synthesize/sensor_noise.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The poses of the sensors on the segments of the body.
struct SensorMounts {
  std::array<Pose, 3> segment_from_sensor;  ///< shoulder (trunk), elbow (upper arm), wrist (hand)
};
/// Draws the mounts of all sensors.
SensorMounts draw_mounts(const SyntheticSensors& options, math::RandomStream& random);

/// Simulates the tracker's measurements of an arm that is sampled at its rate, with noise. Its
/// clock begins at 0.
BodyStream simulate_sensors(const SyntheticSensors& options, const SensorMounts& mounts,
                            const std::vector<ArmSample>& arm, math::RandomStream& random);
/// Draws lost samples of each sensor and replaces them by NaN.
void apply_dropouts(const SyntheticSensors& options, math::RandomStream& random, BodyStream& body);

/// Adds noise to an object as if it were tracked by a sensor of its own.
void add_noise(const SyntheticSensors& options, math::RandomStream& random, SceneObject& object);

}  // namespace morphe::synthesize
