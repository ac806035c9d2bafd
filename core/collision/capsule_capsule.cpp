#include <algorithm>
#include <cmath>

#include "core/collision/closest_points.hpp"
#include "core/collision/distance.hpp"

namespace morphe::collision {
namespace {

/// Returns the parameter in [0, 1] of the segment's point nearest to `point`.
double project(const Vec3& point, const Vec3& from, const Vec3& along, double squared_length) {
  if (squared_length <= 0) return 0;
  return std::clamp((point - from).dot(along) / squared_length, 0.0, 1.0);
}

/// Tries the four end points. If the segments are nearly parallel, the linear system is
/// ill-conditioned, and one of the ends is as near as any point to within rounding.
void try_ends(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, ClosestPoints& best) {
  const auto keep = [&best](const Vec3& on_first, const Vec3& on_second) {
    const double squared = (on_first - on_second).squaredNorm();
    if (squared < best.squared) best = {on_first, on_second, squared};
  };
  const Vec3 u = b - a, v = d - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  for (const Vec3& end : {a, b}) keep(end, c + project(end, c, v, vv) * v);
  for (const Vec3& end : {c, d}) keep(a + project(end, a, u, uu) * u, end);
}

/// Returns a unit vector perpendicular to both segments, deterministic for the same input.
Vec3 common_normal(const Vec3& u, const Vec3& v) {
  const Vec3 common = u.cross(v);
  if (common.squaredNorm() > 1e-12 * u.squaredNorm() * v.squaredNorm()) return common.normalized();
  const Vec3& longer = u.squaredNorm() >= v.squaredNorm() ? u : v;
  if (longer.squaredNorm() <= 0) return Vec3::UnitZ();
  int least = 0;
  longer.cwiseAbs().minCoeff(&least);
  return longer.cross(Vec3::Unit(least)).normalized();
}

}  // namespace

ClosestPoints closest_points_of_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                         const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  double s = 0;
  if (determinant > 0) {
    s = std::clamp((uv * v.dot(w) - vv * u.dot(w)) / determinant, 0.0, 1.0);
  }
  const double t = project(a + s * u, c, v, vv);
  s = project(c + t * v, a, u, uu);
  ClosestPoints best{a + s * u, c + t * v, 0};
  best.squared = (best.on_first - best.on_second).squaredNorm();
  if (determinant <= 1e-6 * uu * vv) try_ends(a, b, c, d, best);
  return best;
}

Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second) {
  const ClosestPoints near =
      closest_points_of_segments(first.from, first.to, second.from, second.to);
  const double apart = std::sqrt(near.squared);
  Separation result;
  result.distance = apart - first.radius - second.radius;
  result.normal = apart > 1e-12 ? Vec3((near.on_first - near.on_second) / apart)
                                : common_normal(first.to - first.from, second.to - second.from);
  result.on_first = near.on_first - first.radius * result.normal;
  result.on_second = near.on_second + second.radius * result.normal;
  return result;
}

}  // namespace morphe::collision
