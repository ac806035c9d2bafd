#include <algorithm>
#include <cmath>

#include "core/collision/constants.hpp"
#include "core/collision/distance.hpp"

namespace morphe::collision {
namespace {

/// Returns the parameter in [0, 1] of the point nearest to `point` on the segment from + s * along.
double project(const Vec3& point, const Vec3& from, const Vec3& along, double squared_length) {
  if (squared_length <= 0) return 0;
  return std::clamp((point - from).dot(along) / squared_length, 0.0, 1.0);
}

/// Replaces `closest` if an end point of one segment is nearer to the other segment. If the
/// segments are nearly parallel, so that their linear system is ill-conditioned, an end point is
/// nearest to within rounding.
void try_ends(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, ClosestPoints& closest) {
  const auto try_points = [&closest](const Vec3& on_first, const Vec3& on_second) {
    const double squared = (on_first - on_second).squaredNorm();
    if (squared < closest.squared_distance) closest = {on_first, on_second, squared};
  };
  const Vec3 u = b - a, v = d - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  for (const Vec3& end : {a, b}) try_points(end, c + project(end, c, v, vv) * v);
  for (const Vec3& end : {c, d}) try_points(a + project(end, a, u, uu) * u, end);
}

/// Returns a unit vector perpendicular to two vectors; if they are parallel, one perpendicular to
/// the longer; if both are zero, z.
Vec3 common_normal(const Vec3& u, const Vec3& v) {
  const Vec3 common = u.cross(v);
  if (common.squaredNorm() > 1e-12 * u.squaredNorm() * v.squaredNorm()) return common.normalized();
  const Vec3& longer = u.squaredNorm() >= v.squaredNorm() ? u : v;
  if (longer.squaredNorm() <= 0) return Vec3::UnitZ();
  int smallest_axis = 0;
  longer.cwiseAbs().minCoeff(&smallest_axis);
  return longer.cross(Vec3::Unit(smallest_axis)).normalized();
}

}  // namespace

ClosestPoints closest_points_of_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                         const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  double s = 0;
  if (determinant > 0) s = std::clamp((uv * v.dot(w) - vv * u.dot(w)) / determinant, 0.0, 1.0);
  const double t = project(a + s * u, c, v, vv);
  s = project(c + t * v, a, u, uu);
  ClosestPoints closest{a + s * u, c + t * v, 0};
  closest.squared_distance = (closest.on_first - closest.on_second).squaredNorm();
  if (determinant <= kParallelSquaredSine * uu * vv) try_ends(a, b, c, d, closest);
  return closest;
}

Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second) {
  const auto [on_first, on_second, squared_distance] =
      closest_points_of_segments(first.from, first.to, second.from, second.to);
  const double distance = std::sqrt(squared_distance);
  const Vec3 normal = distance > kCoincidence_m
                          ? Vec3((on_first - on_second) / distance)
                          : common_normal(first.to - first.from, second.to - second.from);
  return {distance - first.radius - second.radius, on_first - first.radius * normal,
          on_second + second.radius * normal, normal};
}

}  // namespace morphe::collision
