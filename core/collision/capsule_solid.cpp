#include <algorithm>
#include <cmath>

#include "core/collision/constants.hpp"
#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

/// Returns |x|, and its derivative as `sign`: +1 at zero.
double magnitude(double x, double& sign) {
  sign = x < 0 ? -1.0 : 1.0;
  return std::abs(x);
}

double box_distance(const Vec3& point, const Vec3& half, Vec3& gradient) {
  Vec3 sign, beyond;
  for (int k = 0; k < 3; ++k) beyond[k] = magnitude(point[k], sign[k]) - half[k];
  int axis = 0;
  const double largest_excess = beyond.maxCoeff(&axis);
  if (largest_excess <= 0) {
    gradient = sign[axis] * Vec3::Unit(axis);
    return largest_excess;
  }
  const Vec3 outside = beyond.cwiseMax(0.0);
  const double distance = outside.norm();
  gradient = outside.cwiseProduct(sign) / distance;
  return distance;
}

double cylinder_distance(const Vec3& point, double radius, double half_length, Vec3& gradient) {
  const double rho = std::hypot(point.x(), point.y());
  const Vec3 radial = rho > 0 ? Vec3(point.x() / rho, point.y() / rho, 0) : Vec3(Vec3::UnitX());
  double sign = 1;
  const double beyond_side = rho - radius;
  const double beyond_end = magnitude(point.z(), sign) - half_length;
  if (beyond_side <= 0 && beyond_end <= 0) {
    gradient = beyond_side >= beyond_end ? radial : Vec3(sign * Vec3::UnitZ());
    return std::max(beyond_side, beyond_end);
  }
  const double side = std::max(beyond_side, 0.0), end = std::max(beyond_end, 0.0);
  const double distance = std::hypot(side, end);
  gradient = (side * radial + end * sign * Vec3::UnitZ()) / distance;
  return distance;
}

double capsule_distance(const Vec3& point, double radius, double half_length, Vec3& gradient) {
  const Vec3 from_axis = point - std::clamp(point.z(), -half_length, half_length) * Vec3::UnitZ();
  const double length = from_axis.norm();
  gradient = length > 0 ? Vec3(from_axis / length) : Vec3(Vec3::UnitX());
  return length - radius;
}

/// The point of a segment at which the signed distance from a convex solid is smallest.
struct Deepest {
  double distance = 0;
  Vec3 point;     ///< in the solid's frame
  Vec3 gradient;  ///< of the signed distance at the point
  Vec3 normal;    ///< gradient of the minimum with respect to a translation of the segment
};

/// Bisects the segment by the sign of the signed distance's slope along it. The normal is a
/// weighted sum of the gradients at both ends of the last interval, perpendicular to the segment.
Deepest deepest_point(const Solid& solid, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  Deepest deepest;
  struct Probe {
    double s, slope;
    Vec3 gradient;
  };
  const auto probe = [&](double s) {
    deepest.point = from + s * along;
    deepest.distance = signed_distance(solid, deepest.point, deepest.gradient);
    deepest.normal = deepest.gradient;
    return Probe{s, deepest.gradient.dot(along), deepest.gradient};
  };
  Probe low = probe(0);
  if (low.slope >= 0) return deepest;
  Probe high = probe(1);
  if (high.slope <= 0) return deepest;
  const double resolution = kSegmentResolution_m / along.norm();
  while (high.s - low.s > resolution) {
    const Probe middle = probe(0.5 * (low.s + high.s));
    if (middle.slope == 0) return deepest;
    (middle.slope < 0 ? low : high) = middle;
  }
  const double low_weight = high.slope / (high.slope - low.slope);
  deepest.normal = low_weight * low.gradient + (1 - low_weight) * high.gradient;
  const double length = deepest.normal.norm();
  deepest.normal = length > 1e-6 ? Vec3(deepest.normal / length)
                   : low.s < 0.5 ? high.gradient
                                 : low.gradient;
  return deepest;
}

}  // namespace

double signed_distance(const Solid& solid, const Vec3& point, Vec3& gradient) {
  const std::vector<double>& size = solid.object.size;
  switch (solid.object.shape) {
    case Shape::sphere:
      return capsule_distance(point, size[0], 0, gradient);
    case Shape::box:
      return box_distance(point, 0.5 * Vec3(size[0], size[1], size[2]), gradient);
    case Shape::cylinder:
      return cylinder_distance(point, size[0], 0.5 * size[1], gradient);
    case Shape::capsule:
      return capsule_distance(point, size[0], 0.5 * size[1], gradient);
    case Shape::mesh:
      break;
  }
  if (solid.mesh) return mesh_distance(*solid.mesh, point, gradient);
  gradient = Vec3::UnitZ();
  return -kInvalidMeshDepth_m;
}

double signed_distance_lower_bound(const Solid& solid, const Vec3& point) {
  // Without gradients, because this is called for every pair of a capsule and an object.
  const std::vector<double>& size = solid.object.size;
  const auto distance = [](double largest_excess, double squared_outside) {
    return largest_excess <= 0 ? largest_excess : std::sqrt(squared_outside);
  };
  const auto square = [](double x) { return x > 0 ? x * x : 0; };
  switch (solid.object.shape) {
    case Shape::sphere:
      return point.norm() - size[0];
    case Shape::box: {
      const double x = std::abs(point.x()) - 0.5 * size[0];
      const double y = std::abs(point.y()) - 0.5 * size[1];
      const double z = std::abs(point.z()) - 0.5 * size[2];
      return distance(std::max({x, y, z}), square(x) + square(y) + square(z));
    }
    case Shape::cylinder: {
      const double side = std::sqrt(point.x() * point.x() + point.y() * point.y()) - size[0];
      const double end = std::abs(point.z()) - 0.5 * size[1];
      return distance(std::max(side, end), square(side) + square(end));
    }
    case Shape::capsule: {
      const double end = std::max(std::abs(point.z()) - 0.5 * size[1], 0.0);
      return std::sqrt(point.head<2>().squaredNorm() + end * end) - size[0];
    }
    case Shape::mesh:
      break;
  }
  return solid.mesh ? mesh_distance_lower_bound(*solid.mesh, point) : -kInvalidMeshDepth_m;
}

double bounding_radius(const Solid& solid) {
  const std::vector<double>& size = solid.object.size;
  switch (solid.object.shape) {
    case Shape::sphere:
      return size[0];
    case Shape::box:
      return 0.5 * Vec3(size[0], size[1], size[2]).norm();
    case Shape::cylinder:
      return std::hypot(size[0], 0.5 * size[1]);
    case Shape::capsule:
      return size[0] + 0.5 * size[1];
    case Shape::mesh:
      break;
  }
  return solid.mesh ? solid.mesh->radius : kInvalidMeshDepth_m;
}

Separation capsule_solid(const CapsuleBody& first, const Solid& solid, const Pose& pose) {
  if (solid.object.shape == Shape::sphere || solid.object.shape == Shape::capsule) {
    const double half = solid.object.shape == Shape::sphere ? 0 : 0.5 * solid.object.size[1];
    const Vec3 arm = half * pose.linear().col(2);
    return capsule_capsule(
        first, {pose.translation() - arm, pose.translation() + arm, solid.object.size[0]});
  }
  const Eigen::Matrix3d solid_from_common = pose.linear().transpose();
  const Vec3 from = solid_from_common * (first.from - pose.translation());
  const Vec3 to = solid_from_common * (first.to - pose.translation());
  if (solid.object.shape == Shape::mesh && solid.mesh) {
    Separation result = capsule_mesh({from, to, first.radius}, *solid.mesh);
    result.normal = pose.linear() * result.normal;
    result.on_first = pose * result.on_first;
    result.on_second = pose * result.on_second;
    return result;
  }
  const Deepest deepest = deepest_point(solid, from, to);
  Separation result;
  result.distance = deepest.distance - first.radius;
  result.normal = pose.linear() * deepest.normal;
  result.on_first = pose * deepest.point - first.radius * result.normal;
  result.on_second = pose * (deepest.point - deepest.distance * deepest.gradient);
  return result;
}

}  // namespace morphe::collision
