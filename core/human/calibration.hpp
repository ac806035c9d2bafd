#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::human {

/// Computes the offsets of the sensors from a calibration pose, a static recording in which joint
/// centres were digitised: with the means over its frames of each sensor's pose and of each marker,
///   joint_in_sensor     = sensor_from_world * joint centre of the sensor's name
///   sensor_from_segment = sensor_from_world * world_from_hand      (wrist; else the identity)
/// Axes of the hand: z from the marker wrist to middle_mcp, y from little_mcp to index_mcp made
/// orthogonal, x = y × z. Sensors are called shoulder, elbow, wrist. Missing data is reported in
/// `problems`, a sentence each, and that sensor gets no offset. Without sensors there are neither
/// offsets nor reports.
SensorOffsets sensor_offsets(const Streams& calibration, std::vector<std::string>& problems);

/// Returns the mean of the known rotations, which are close together; NaN if there are no known
/// rotations.
Quat mean_rotation(const std::vector<Quat>& rotations);

}  // namespace morphe::human
