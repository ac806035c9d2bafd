#include "stages/reconstruct/sensor_joints.hpp"

#include <algorithm>

namespace morphe::reconstruct {
namespace {

/// Returns the index of a name, if it exists.
std::optional<std::size_t> find(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return found - names.begin();
}

}  // namespace

std::optional<BodyTrack> joint_of_sensor(const Demonstration& demonstration,
                                         const std::string& name,
                                         std::vector<std::string>& problems) {
  const BodyStream& sensors = *demonstration.streams.sensors;
  const auto body = find(sensors.names, name);
  if (!body) return std::nullopt;
  BodyTrack track;
  for (std::size_t i = 0; i < sensors.time.size(); ++i) {
    track.position.push_back(sensors.position(i, *body));
    track.orientation.push_back(sensors.orientation(i, *body));
  }
  if (!demonstration.sensor_offsets) return track;
  const SensorOffsets& offsets = *demonstration.sensor_offsets;
  const auto offset = find(offsets.sensors, name);
  if (!offset) {
    problems.push_back("the sensor " + name +
                       " was not calibrated: it is assumed to be at the joint");
    return track;
  }
  for (std::size_t i = 0; i < sensors.time.size(); ++i) {
    const Quat world_from_sensor = track.orientation[i];
    track.position[i] += world_from_sensor * offsets.joint_in_sensor[*offset];
    track.orientation[i] = world_from_sensor * offsets.sensor_from_segment[*offset];
  }
  return track;
}

}  // namespace morphe::reconstruct
