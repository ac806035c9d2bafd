#include "pipeline/place/base_placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.hpp"
#include "pipeline/place/constants.hpp"

namespace morphe::place {
namespace {

/// Returns the mount's direction nearest to the axis `up`, unknown if all directions are allowed.
Vec3 mount_axis(MountDirection mount, const Vec3& up) {
  const auto horizontal = [](double x, double y) -> Vec3 {
    const double norm = std::hypot(x, y);
    return norm > 1e-9 ? Vec3(x / norm, y / norm, 0) : Vec3::UnitX();
  };
  switch (mount) {
    case MountDirection::any:
      break;
    case MountDirection::floor:
      return Vec3::UnitZ();
    case MountDirection::ceiling:
      return -Vec3::UnitZ();
    case MountDirection::wall:
      return horizontal(up.x(), up.y());
    case MountDirection::side:
      return {up.x() < 0 ? -1.0 : 1.0, 0, 0};
  }
  return unknown_point();
}

Quat rotation_from_vertical(const Vec3& up) {
  return math::shortest_rotation(Vec3::UnitZ(), up).normalized();
}

/// Draws uniformly from the unit vectors whose component along `axis` is at least `min_z`.
Vec3 sample_spherical_cap(const Vec3& axis, double min_z, math::RandomStream& random) {
  const double z = random.uniform(min_z, 1), azimuth = random.uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return rotation_from_vertical(axis) * Vec3(r * std::cos(azimuth), r * std::sin(azimuth), z);
}

Vec3 sample_base_axis(const PlaceOptions& options, math::RandomStream& random) {
  const double min_z = std::cos(options.max_tilt_rad);
  switch (options.mount) {
    case MountDirection::any:
      break;
    case MountDirection::wall: {
      const double azimuth = random.uniform(0, 2 * std::numbers::pi);
      const double z = std::sin(options.max_tilt_rad) * random.uniform(-1, 1);
      const double r = std::sqrt(1 - z * z);
      return {r * std::cos(azimuth), r * std::sin(azimuth), z};
    }
    case MountDirection::side:
      return sample_spherical_cap({random.bernoulli(0.5) ? 1.0 : -1.0, 0, 0}, min_z, random);
    case MountDirection::floor:
    case MountDirection::ceiling:
      return sample_spherical_cap(mount_axis(options.mount, Vec3::UnitZ()), min_z, random);
  }
  return sample_spherical_cap(Vec3::UnitZ(), -1, random);
}

/// Returns true if the robot has a direction to which it faces, which must be the person's.
bool must_face_forward(const PlaceOptions& options) {
  return options.mount == MountDirection::floor && options.standing.has_body();
}

/// Returns the angle from the person's forward direction to that of the robot, to the right.
double facing_angle(const PlaceOptions& options, const Quat& world_from_base) {
  const Vec3 forward = world_from_base * options.standing.forward;
  return std::atan2(forward.x(), forward.y());
}

Quat turned_about_vertical(double angle_rad, const Quat& rotation) {
  return (Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ())) * rotation).normalized();
}

/// Turns the base about the vertical by as little as possible until it faces the person's way.
Quat face_forward(const PlaceOptions& options, const Quat& world_from_base) {
  const double angle = facing_angle(options, world_from_base);
  const double allowed = std::clamp(angle, -kMaxFacingAngle_rad, kMaxFacingAngle_rad);
  return turned_about_vertical(angle - allowed, world_from_base);
}

}  // namespace

BasePlacement base_placement_of(const map::PlacementOptions& placement) {
  return {Quat(map::rotation_of(placement)).normalized(), placement.shoulder_offset};
}

map::PlacementOptions placement_of(const BasePlacement& pose) {
  const Eigen::Matrix3d r = pose.world_from_base.toRotationMatrix();
  const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  double z = std::atan2(r(1, 0), r(0, 0)), x = std::atan2(r(2, 1), r(2, 2));
  if (std::abs(r(2, 0)) > 1 - 1e-9) {  // z and x turn about the same line
    z = std::atan2(-r(0, 1), r(1, 1));
    x = 0;
  }
  map::PlacementOptions placement;
  const auto turn = [&](const char* axis, double angle) {
    const double tenths = std::round(angle / kRadPerDegree * 10);
    if (tenths != 0) placement.rotation.push_back({axis, tenths / 10 * kRadPerDegree});
  };
  turn("z", z);
  turn("y", y);
  turn("x", x);
  for (int k = 0; k < 3; ++k)
    placement.shoulder_offset[k] = std::round(pose.shoulder_offset[k] * 1e3) / 1e3;
  placement.found_by = map::PlacementFinder::place;
  return placement;
}

BasePlacement project_to_constraints(const BasePlacement& pose, const BasePlacement& configured,
                                     const PlaceOptions& options) {
  BasePlacement allowed = pose;
  allowed.shoulder_offset =
      pose.shoulder_offset.cwiseMax(kMinShoulderOffset_m).cwiseMin(kMaxShoulderOffset_m);
  if (options.fixed.x) allowed.shoulder_offset.x() = configured.shoulder_offset.x();
  if (options.fixed.y) allowed.shoulder_offset.y() = configured.shoulder_offset.y();
  if (options.fixed.z) allowed.shoulder_offset.z() = configured.shoulder_offset.z();
  if (options.fixed.rotation) {
    allowed.world_from_base = configured.world_from_base;
    return allowed;
  }
  const Vec3 up = pose.up(options.standing.up), direction = mount_axis(options.mount, up);
  if (!is_known(direction)) return allowed;
  const double tilt = std::atan2(direction.cross(up).norm(), direction.dot(up));
  if (tilt > options.max_tilt_rad) {
    Vec3 axis = up.cross(direction);
    axis = axis.norm() > 1e-9 ? axis.normalized() : up.unitOrthogonal();
    const Quat upright(Eigen::AngleAxisd(tilt - options.max_tilt_rad, axis));
    allowed.world_from_base = (upright * pose.world_from_base).normalized();
  }
  if (must_face_forward(options))
    allowed.world_from_base = face_forward(options, allowed.world_from_base);
  return allowed;
}

BasePlacement random_base_placement(const BasePlacement& configured, const PlaceOptions& options,
                                    math::RandomStream& random) {
  BasePlacement pose;
  const Vec3 up = sample_base_axis(options, random);
  const double turn_rad = random.uniform(0, 2 * std::numbers::pi);
  const Quat vertical_from_base =
      math::shortest_rotation(options.standing.up, Vec3::UnitZ()).normalized();
  pose.world_from_base =
      (rotation_from_vertical(up) * turned_about_vertical(turn_rad, vertical_from_base))
          .normalized();
  if (must_face_forward(options)) {
    const double allowed = kMaxFacingAngle_rad * (turn_rad / std::numbers::pi - 1);
    pose.world_from_base = turned_about_vertical(
        facing_angle(options, pose.world_from_base) - allowed, pose.world_from_base);
  }
  for (int k = 0; k < 3; ++k)
    pose.shoulder_offset[k] = random.uniform(kMinShoulderOffset_m[k], kMaxShoulderOffset_m[k]);
  return project_to_constraints(pose, configured, options);
}

}  // namespace morphe::place
