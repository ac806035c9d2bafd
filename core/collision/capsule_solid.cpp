#include <algorithm>
#include <cmath>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

/// Length of the part of the segment at which the search for the minimum ends [m].
constexpr double kResolution_m = 1e-10;
/// Depth of every point in a mesh without triangles [m].
constexpr double kBrokenMesh_m = 1;

/// Returns |x|, and its derivative, which is +1 at zero.
double magnitude(double x, double& sign) {
  sign = x < 0 ? -1.0 : 1.0;
  return std::abs(x);
}

double box_distance(const Vec3& point, const Vec3& half, Vec3& gradient) {
  Vec3 sign, beyond;
  for (int k = 0; k < 3; ++k) beyond[k] = magnitude(point[k], sign[k]) - half[k];
  int most = 0;
  const double inside = beyond.maxCoeff(&most);
  if (inside <= 0) {
    gradient = sign[most] * Vec3::Unit(most);
    return inside;
  }
  const Vec3 out = beyond.cwiseMax(0.0);
  const double distance = out.norm();
  gradient = out.cwiseProduct(sign) / distance;
  return distance;
}

double cylinder_distance(const Vec3& point, double radius, double half_length, Vec3& gradient) {
  const double from_axis = std::hypot(point.x(), point.y());
  const Vec3 radial =
      from_axis > 0 ? Vec3(point.x() / from_axis, point.y() / from_axis, 0) : Vec3(Vec3::UnitX());
  double sign = 1;
  const double beyond_side = from_axis - radius;
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

/// The smallest signed distance along from + s * along, s in [0, 1], of a convex solid.
struct Deepest {
  double distance = 0;
  Vec3 point;     ///< in the solid's frame
  Vec3 gradient;  ///< of the signed distance at the point
  Vec3 normal;    ///< gradient of the minimum with respect to a translation of the segment
};

/// Bisects the segment by the sign of the slope. In the end, the slopes on both sides give the
/// weights of the two gradients in the gradient of the minimum: their sum must not change along the
/// segment.
Deepest deepest_point(const Solid& solid, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  Deepest best;
  const auto probe = [&](double s, Vec3& gradient) {
    best.point = from + s * along;
    best.distance = signed_distance(solid, best.point, gradient);
    return gradient.dot(along);
  };
  Vec3 low_gradient, high_gradient;
  double low = 0, high = 1;
  double low_slope = probe(0, low_gradient);
  if (low_slope >= 0) {
    best.gradient = best.normal = low_gradient;
    return best;
  }
  double high_slope = probe(1, high_gradient);
  if (high_slope <= 0) {
    best.gradient = best.normal = high_gradient;
    return best;
  }
  const double resolution = kResolution_m / along.norm();
  while (high - low > resolution) {
    const double middle = 0.5 * (low + high);
    const double slope = probe(middle, best.gradient);
    if (slope == 0) {
      best.normal = best.gradient;
      return best;
    }
    (slope < 0 ? low : high) = middle;
    (slope < 0 ? low_slope : high_slope) = slope;
    (slope < 0 ? low_gradient : high_gradient) = best.gradient;
  }
  const double share = high_slope / (high_slope - low_slope);
  best.normal = share * low_gradient + (1 - share) * high_gradient;
  const double length = best.normal.norm();
  best.normal = length > 1e-6 ? Vec3(best.normal / length)
                : low < 0.5   ? high_gradient
                              : low_gradient;
  return best;
}

}  // namespace

double signed_distance(const Solid& solid, const Vec3& point, Vec3& gradient) {
  switch (solid.object.shape) {
    case Shape::sphere:
      return capsule_distance(point, solid.object.size[0], 0, gradient);
    case Shape::box:
      return box_distance(
          point, 0.5 * Vec3(solid.object.size[0], solid.object.size[1], solid.object.size[2]),
          gradient);
    case Shape::cylinder:
      return cylinder_distance(point, solid.object.size[0], 0.5 * solid.object.size[1], gradient);
    case Shape::capsule:
      return capsule_distance(point, solid.object.size[0], 0.5 * solid.object.size[1], gradient);
    case Shape::mesh:
      break;
  }
  if (solid.mesh) return mesh_distance(*solid.mesh, point, gradient);
  gradient = Vec3::UnitZ();
  return -kBrokenMesh_m;
}

double signed_distance_lower_bound(const Solid& solid, const Vec3& point) {
  // Gradients are omitted, because this is called for every part of the robot and every object.
  const std::vector<double>& size = solid.object.size;
  const auto beyond = [](double most, double out_squared) {
    return most <= 0 ? most : std::sqrt(out_squared);
  };
  const auto square = [](double x) { return x > 0 ? x * x : 0; };
  switch (solid.object.shape) {
    case Shape::sphere:
      return point.norm() - size[0];
    case Shape::box: {
      const double x = std::abs(point.x()) - 0.5 * size[0];
      const double y = std::abs(point.y()) - 0.5 * size[1];
      const double z = std::abs(point.z()) - 0.5 * size[2];
      return beyond(std::max({x, y, z}), square(x) + square(y) + square(z));
    }
    case Shape::cylinder: {
      const double side = std::sqrt(point.x() * point.x() + point.y() * point.y()) - size[0];
      const double end = std::abs(point.z()) - 0.5 * size[1];
      return beyond(std::max(side, end), square(side) + square(end));
    }
    case Shape::capsule: {
      const double end = std::max(std::abs(point.z()) - 0.5 * size[1], 0.0);
      return std::sqrt(point.head<2>().squaredNorm() + end * end) - size[0];
    }
    case Shape::mesh:
      break;
  }
  return solid.mesh ? mesh_distance_lower_bound(*solid.mesh, point) : -kBrokenMesh_m;
}

double bounding_radius(const Solid& solid) {
  switch (solid.object.shape) {
    case Shape::sphere:
      return solid.object.size[0];
    case Shape::box:
      return 0.5 * Vec3(solid.object.size[0], solid.object.size[1], solid.object.size[2]).norm();
    case Shape::cylinder:
      return std::hypot(solid.object.size[0], 0.5 * solid.object.size[1]);
    case Shape::capsule:
      return solid.object.size[0] + 0.5 * solid.object.size[1];
    case Shape::mesh:
      break;
  }
  return solid.mesh ? solid.mesh->radius : kBrokenMesh_m;
}

Separation capsule_solid(const CapsuleBody& first, const Solid& solid, const Pose& pose) {
  if (solid.object.shape == Shape::sphere || solid.object.shape == Shape::capsule) {
    const double half = solid.object.shape == Shape::sphere ? 0 : 0.5 * solid.object.size[1];
    const Vec3 arm = half * pose.linear().col(2);
    return capsule_capsule(
        first, {pose.translation() - arm, pose.translation() + arm, solid.object.size[0]});
  }
  const Eigen::Matrix3d solid_from_common = pose.linear().transpose();
  if (solid.object.shape == Shape::mesh && solid.mesh) {
    Separation result =
        capsule_mesh({solid_from_common * (first.from - pose.translation()),
                      solid_from_common * (first.to - pose.translation()), first.radius},
                     *solid.mesh);
    result.normal = pose.linear() * result.normal;
    result.on_first = pose * result.on_first;
    result.on_second = pose * result.on_second;
    return result;
  }
  const Deepest deepest =
      deepest_point(solid, solid_from_common * (first.from - pose.translation()),
                    solid_from_common * (first.to - pose.translation()));
  const Vec3 surface = deepest.point - deepest.distance * deepest.gradient;
  Separation result;
  result.distance = deepest.distance - first.radius;
  result.normal = pose.linear() * deepest.normal;
  result.on_first = pose * deepest.point - first.radius * result.normal;
  result.on_second = pose * surface;
  return result;
}

}  // namespace morphe::collision
