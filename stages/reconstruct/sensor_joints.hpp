#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// One body's recorded pose, frame by frame.
struct BodyTrack {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
};

/// The joint centre that a sensor stands for and its segment's axes, as recorded (not filtered):
///   joint = sensor position + sensor orientation * joint_in_sensor
///   axes  = sensor orientation * sensor_from_segment
/// Without offsets for the sensor it stands at the joint itself, and has the axes of the segment;
/// said in `problems` if other sensors have theirs. Nothing if no body has that name.
std::optional<BodyTrack> joint_of_sensor(const Demonstration& demonstration,
                                         const std::string& name,
                                         std::vector<std::string>& problems);

}  // namespace morphe::reconstruct
