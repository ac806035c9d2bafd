#pragma once

#include <array>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/motion_samples.hpp"
#include "pipeline/synthesize/sensor_noise.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Where a sensor sits on its segment: world_from_sensor = world_from_segment *
/// segment_from_sensor.
struct SensorMounts {
  std::array<Pose, 3> segment_from_sensor;  ///< shoulder (trunk), elbow (upper arm), wrist (hand)
};
SensorMounts draw_mounts(const SyntheticSensors& options, math::RandomStream& random);

/// What the tracker says of an arm that moves so, with noise, on its own clock from `first` on.
BodyStream simulate_sensors(const SyntheticSensors& options, const SensorMounts& mounts,
                            const std::vector<ArmAt>& arm, math::RandomStream& random);
/// Replaces what was lost by NaN.
void drop(const SyntheticSensors& options, math::RandomStream& random, BodyStream& sensors);

/// The object, tracked by a sensor of its own.
void add_noise(const SyntheticSensors& options, math::RandomStream& random, SceneObject& object);

}  // namespace morphe::synthesize
