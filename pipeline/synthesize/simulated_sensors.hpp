#pragma once

#include <array>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/motion_samples.hpp"
#include "pipeline/synthesize/sensor_noise.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The mounts of the sensors on their segments: world_from_sensor = world_from_segment *
/// segment_from_sensor.
struct SensorMounts {
  std::array<Pose, 3> segment_from_sensor;  ///< shoulder (trunk), elbow (upper arm), wrist (hand)
};
/// Draws the mounts of all sensors.
SensorMounts draw_mounts(const SyntheticSensors& options, math::RandomStream& random);

/// Simulates the measurements of the tracker for a moving arm, with noise, on its own clock from
/// the first sample on.
BodyStream simulate_sensors(const SyntheticSensors& options, const SensorMounts& mounts,
                            const std::vector<ArmSample>& arm, math::RandomStream& random);
/// Replaces lost samples by NaN.
void drop(const SyntheticSensors& options, math::RandomStream& random, BodyStream& sensors);

/// Adds noise to an object as if it were tracked by a sensor of its own.
void add_noise(const SyntheticSensors& options, math::RandomStream& random, SceneObject& object);

}  // namespace morphe::synthesize
