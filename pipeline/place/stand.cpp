#include "pipeline/place/stand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.hpp"

namespace morphe::place {
namespace {

/// The middle of a mount's directions nearest to an axis; unseen: all are allowed.
Vec3 middle_of(Mount mount, const Vec3& up) {
  const auto level = [](double x, double y) -> Vec3 {
    const double norm = std::hypot(x, y);
    return norm > 1e-9 ? Vec3(x / norm, y / norm, 0) : Vec3::UnitX();
  };
  switch (mount) {
    case Mount::any:
      break;
    case Mount::floor:
      return Vec3::UnitZ();
    case Mount::ceiling:
      return -Vec3::UnitZ();
    case Mount::wall:
      return level(up.x(), up.y());
    case Mount::side:
      return {up.x() < 0 ? -1.0 : 1.0, 0, 0};
  }
  return unseen_point();
}

/// The rotation of a base with this axis that turns least from upright.
Quat upright_to(const Vec3& up) { return math::shortest_rotation(Vec3::UnitZ(), up).normalized(); }

/// Even on the unit sphere's part from z = least to 1 about an axis.
Vec3 in_cap(const Vec3& axis, double least, math::RandomStream& random) {
  const double z = random.uniform(least, 1), around = random.uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return upright_to(axis) * Vec3(r * std::cos(around), r * std::sin(around), z);
}

Vec3 random_up(const PlaceOptions& options, math::RandomStream& random) {
  const double least = std::cos(options.tilt_rad);
  switch (options.mount) {
    case Mount::any:
      break;
    case Mount::wall: {
      const double around = random.uniform(0, 2 * std::numbers::pi);
      const double z = std::sin(options.tilt_rad) * random.uniform(-1, 1);
      const double r = std::sqrt(1 - z * z);
      return {r * std::cos(around), r * std::sin(around), z};
    }
    case Mount::side:
      return in_cap({random.chance(0.5) ? 1.0 : -1.0, 0, 0}, least, random);
    case Mount::floor:
    case Mount::ceiling:
      return in_cap(middle_of(options.mount, Vec3::UnitZ()), least, random);
  }
  return in_cap(Vec3::UnitZ(), -1, random);
}

}  // namespace

Stand stand_of(const map::PlacementOptions& placement) {
  return {Quat(map::rotation_of(placement)).normalized(), placement.shoulder_offset};
}

map::PlacementOptions placement_of(const Stand& stand) {
  const Eigen::Matrix3d r = stand.world_from_base.toRotationMatrix();
  const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  double z = std::atan2(r(1, 0), r(0, 0)), x = std::atan2(r(2, 1), r(2, 2));
  if (std::abs(r(2, 0)) > 1 - 1e-9) {  // z and x turn about the same line
    z = std::atan2(-r(0, 1), r(1, 1));
    x = 0;
  }
  map::PlacementOptions placement;
  const auto turn = [&](const char* axis, double angle) {
    const double tenths = std::round(angle / kDegree * 10);
    if (tenths != 0) placement.rotation.push_back({axis, tenths / 10 * kDegree});
  };
  turn("z", z);
  turn("y", y);
  turn("x", x);
  for (Eigen::Index k = 0; k < 3; ++k) {
    placement.shoulder_offset[k] = std::round(stand.shoulder_offset[k] * 1e3) / 1e3;
  }
  return placement;
}

Stand allowed(const Stand& stand, const Stand& configured, const PlaceOptions& options) {
  Stand inside = stand;
  inside.shoulder_offset = stand.shoulder_offset.cwiseMax(kLeastOffset).cwiseMin(kMostOffset);
  if (options.keep.x) inside.shoulder_offset.x() = configured.shoulder_offset.x();
  if (options.keep.y) inside.shoulder_offset.y() = configured.shoulder_offset.y();
  if (options.keep.z) inside.shoulder_offset.z() = configured.shoulder_offset.z();
  if (options.keep.rotation) {
    inside.world_from_base = configured.world_from_base;
    return inside;
  }
  const Vec3 up = stand.up(), middle = middle_of(options.mount, up);
  if (!seen(middle)) return inside;
  const double away = std::atan2(middle.cross(up).norm(), middle.dot(up));
  if (away <= options.tilt_rad) return inside;
  Vec3 axis = up.cross(middle);
  axis = axis.norm() > 1e-9 ? axis.normalized() : up.unitOrthogonal();
  inside.world_from_base =
      (Quat(Eigen::AngleAxisd(away - options.tilt_rad, axis)) * stand.world_from_base).normalized();
  return inside;
}

Stand random_stand(const Stand& configured, const PlaceOptions& options,
                   math::RandomStream& random) {
  Stand stand;
  const Vec3 up = random_up(options, random);
  const double about = random.uniform(0, 2 * std::numbers::pi);
  stand.world_from_base =
      (upright_to(up) * Quat(Eigen::AngleAxisd(about, Vec3::UnitZ()))).normalized();
  for (Eigen::Index k = 0; k < 3; ++k) {
    stand.shoulder_offset[k] = random.uniform(kLeastOffset[k], kMostOffset[k]);
  }
  return allowed(stand, configured, options);
}

}  // namespace morphe::place
