#include "core/human/calibration.hpp"

#include <algorithm>
#include <optional>

namespace morphe::human {
namespace {

template <class T>
std::vector<T> column_of(const Array2D<T>& table, std::size_t column) {
  std::vector<T> values;
  for (std::size_t i = 0; i < table.rows; ++i) values.push_back(table(i, column));
  return values;
}

Vec3 mean_point(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Vec3& point : points) {
    if (!is_known(point)) continue;
    sum += point;
    ++count;
  }
  return sum / count;  // 0 / 0 = NaN if there are no points
}

Vec3 digitised_point(const std::optional<MarkerStream>& markers, const std::string& name) {
  if (!markers) return unknown_point();
  const auto found = std::ranges::find(markers->names, name);
  if (found == markers->names.end()) return unknown_point();
  return mean_point(column_of(markers->position, found - markers->names.begin()));
}

/// Returns the hand's axes in the world, or NaN if a point is missing or the points are degenerate.
Quat world_from_hand(const std::optional<MarkerStream>& markers) {
  const Vec3 z =
      (digitised_point(markers, "middle_mcp") - digitised_point(markers, "wrist")).normalized();
  const Vec3 across =
      digitised_point(markers, "index_mcp") - digitised_point(markers, "little_mcp");
  const Vec3 aside = across - z * z.dot(across);
  constexpr double kMinPalmWidth_m = 0.01;
  if (!(aside.norm() > kMinPalmWidth_m)) return unknown_rotation();
  const Vec3 y = aside.normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return Quat(axes);
}

}  // namespace

Quat mean_rotation(const std::vector<Quat>& rotations) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Quat& rotation : rotations) {
    if (is_known(rotation)) sum += rotation.coeffs() * (sum.dot(rotation.coeffs()) < 0 ? -1 : 1);
  }
  return sum.norm() > 0 ? Quat(Eigen::Vector4d(sum.normalized())) : unknown_rotation();
}

SensorOffsets sensor_offsets(const Streams& calibration, std::vector<std::string>& problems) {
  SensorOffsets offsets;
  if (!calibration.sensors) return offsets;
  const BodyStream& sensors = *calibration.sensors;
  for (int k = 0; k < std::ssize(sensors.names); ++k) {
    const std::string& name = sensors.names[k];
    const Vec3 position = mean_point(column_of(sensors.position, k));
    const Quat orientation = mean_rotation(column_of(sensors.orientation, k));
    const Vec3 joint = digitised_point(calibration.markers, name);
    const Quat segment = name == "wrist" ? world_from_hand(calibration.markers) : orientation;
    std::string reason;
    if (!is_known(position) || !is_known(orientation)) {
      reason = "position and orientation were never both recorded";
    } else if (!is_known(joint)) {
      reason = "no point " + name + " was digitised";
    } else if (!is_known(segment)) {
      reason = "the hand's axes cannot be computed from middle_mcp, index_mcp and little_mcp";
    }
    if (!reason.empty()) {
      problems.push_back("calibration pose: " + reason + "; sensor " + name + " gets no offset");
      continue;
    }
    offsets.sensors.push_back(name);
    offsets.joint_in_sensor.push_back(orientation.conjugate() * (joint - position));
    offsets.sensor_from_segment.push_back(orientation.conjugate() * segment);
  }
  return offsets;
}

}  // namespace morphe::human
