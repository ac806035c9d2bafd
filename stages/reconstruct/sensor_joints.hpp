#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// The recorded poses of one body, frame by frame.
struct BodyTrack {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
};

/// Returns the joint centre of a sensor and the axes of its segment, as recorded (not filtered):
///   joint = sensor position + sensor orientation * joint_in_sensor
///   axes  = sensor orientation * sensor_from_segment
/// Without offsets for the sensor, it is assumed to be at the joint itself, with the axes of the
/// segment; this is reported in `problems` if other sensors have offsets. Returns no track if no
/// body has that name.
std::optional<BodyTrack> joint_of_sensor(const Demonstration& demonstration,
                                         const std::string& name,
                                         std::vector<std::string>& problems);

}  // namespace morphe::reconstruct
