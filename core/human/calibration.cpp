#include "core/human/calibration.hpp"

#include <algorithm>
#include <optional>

namespace morphe::human {
namespace {

template <class T>
std::vector<T> column_of(const Table<T>& table, std::size_t column) {
  std::vector<T> values;
  for (std::size_t i = 0; i < table.rows; ++i) values.push_back(table(i, column));
  return values;
}

Vec3 mean_point(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Vec3& point : points) {
    if (!seen(point)) continue;
    sum += point;
    ++count;
  }
  return sum / count;  // 0 / 0: not seen
}

/// A digitised point; NaN if it is not among the markers.
Vec3 digitised(const std::optional<MarkerStream>& markers, const std::string& name) {
  if (!markers) return unseen_point();
  const auto found = std::find(markers->names.begin(), markers->names.end(), name);
  if (found == markers->names.end()) return unseen_point();
  return mean_point(
      column_of(markers->position, static_cast<std::size_t>(found - markers->names.begin())));
}

/// The hand's axes in the world; NaN if a point is missing or they do not span a hand.
Quat world_from_hand(const std::optional<MarkerStream>& markers) {
  const Vec3 z = (digitised(markers, "middle_mcp") - digitised(markers, "wrist")).normalized();
  const Vec3 across = digitised(markers, "index_mcp") - digitised(markers, "little_mcp");
  const Vec3 aside = across - z * z.dot(across);
  constexpr double kNarrow = 0.01;  // [m]
  if (!(aside.norm() > kNarrow)) return unseen_rotation();
  const Vec3 y = aside.normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return Quat(axes);
}

}  // namespace

Quat mean_rotation(const std::vector<Quat>& rotations) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Quat& rotation : rotations) {
    if (seen(rotation)) sum += rotation.coeffs() * (sum.dot(rotation.coeffs()) < 0 ? -1 : 1);
  }
  return sum.norm() > 0 ? Quat(Eigen::Vector4d(sum.normalized())) : unseen_rotation();
}

SensorOffsets sensor_offsets(const Streams& calibration, std::vector<std::string>& problems) {
  SensorOffsets offsets;
  if (!calibration.sensors) return offsets;
  const BodyStream& sensors = *calibration.sensors;
  for (std::size_t k = 0; k < sensors.names.size(); ++k) {
    const std::string& name = sensors.names[k];
    const auto refuse = [&](const std::string& why) {
      problems.push_back("calibration pose: " + why + ": the sensor " + name + " has no offset");
    };
    const Vec3 position = mean_point(column_of(sensors.position, k));
    const Quat orientation = mean_rotation(column_of(sensors.orientation, k));
    const Vec3 joint = digitised(calibration.markers, name);
    if (!seen(position) || !seen(orientation)) {
      refuse("it was never seen whole");
      continue;
    }
    if (!seen(joint)) {
      refuse("no point " + name + " was digitised");
      continue;
    }
    Quat segment = orientation;
    if (name == "wrist") segment = world_from_hand(calibration.markers);
    if (!seen(segment)) {
      refuse("middle_mcp, index_mcp and little_mcp do not give the hand's axes");
      continue;
    }
    offsets.sensors.push_back(name);
    offsets.joint_in_sensor.push_back(orientation.conjugate() * (joint - position));
    offsets.sensor_from_segment.push_back(orientation.conjugate() * segment);
  }
  return offsets;
}

}  // namespace morphe::human
