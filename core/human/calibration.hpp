#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::human {

/// Computes the offsets of the sensors, called shoulder, elbow and wrist, from a calibration pose:
/// a static recording whose markers include the digitised joint centres. Poses and markers are
/// averaged over its frames:
///   joint_in_sensor     = sensor_from_world * marker with the sensor's name
///   sensor_from_segment = sensor_from_world * world_from_hand, for the wrist; else the identity
/// Axes of the hand: z from the marker wrist to middle_mcp, y from little_mcp to index_mcp made
/// orthogonal, x = y × z. A sensor for which data is missing gets no offset, and a sentence in
/// `problems`. Without a sensor stream there are neither offsets nor sentences.
SensorOffsets sensor_offsets(const Streams& calibration, std::vector<std::string>& problems);

/// Returns the mean of the known rotations, which must be close together; NaN without any.
Quat mean_rotation(const std::vector<Quat>& rotations);

}  // namespace morphe::human
