#include "core/cover/capsule_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/cover/constants.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

double surface_area(const CapsuleBody& capsule) {
  const double length = (capsule.to - capsule.from).norm();
  return 2 * M_PI * capsule.radius * (length + 2 * capsule.radius);
}

}  // namespace

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 axis = to - from;
  const double square = axis.squaredNorm();
  const double fraction = square > 0 ? std::clamp((point - from).dot(axis) / square, 0.0, 1.0) : 0;
  return (point - from - fraction * axis).norm();
}

double union_signed_distance(const std::vector<CapsuleBody>& capsules, const Vec3& point) {
  double min_distance = kInfinity;
  for (const CapsuleBody& c : capsules)
    min_distance = std::min(min_distance, distance_to_segment(point, c.from, c.to) - c.radius);
  return min_distance;
}

std::vector<Vec3> sample_capsule_surface(const CapsuleBody& capsule, int rings, int ring_points) {
  const Vec3 axis = capsule.to - capsule.from;
  const Vec3 z = axis.norm() > 1e-9 ? Vec3(axis.normalized()) : Vec3::UnitZ();
  const Vec3 x = z.unitOrthogonal(), y = z.cross(x);
  const double length = axis.norm(), r = capsule.radius, total = length + 2 * r;
  std::vector<Vec3> points;
  for (int k = 0; k < rings; ++k) {  // equal heights have equal areas on both sphere and cylinder
    const double height = total * (k + 0.5) / rings - r;
    const double beyond = height - std::clamp(height, 0.0, length);
    const double ring_r = std::sqrt(std::max(0.0, r * r - beyond * beyond));
    for (int i = 0; i < ring_points; ++i) {
      const double a = 2 * M_PI * (i + 0.5 * (k % 2)) / ring_points;
      points.emplace_back(capsule.from + height * z + ring_r * (std::cos(a) * x + std::sin(a) * y));
    }
  }
  return points;
}

double standoff_cost(const CapsuleBody& capsule, const Voxels& voxels) {
  double sum = 0;
  const std::vector<Vec3> points = sample_capsule_surface(capsule, kCostRings, kCostRingPoints);
  for (const Vec3& point : points) {
    const double distance = voxels.outside_distance(point);
    sum += distance * distance;
  }
  return surface_area(capsule) * sum / static_cast<double>(points.size());
}

double mean_square_standoff(const std::vector<CapsuleBody>& capsules, const Voxels& voxels) {
  double sum = 0, outer_area = 0;
  for (const CapsuleBody& capsule : capsules) {
    const std::vector<Vec3> points = sample_capsule_surface(capsule, kCostRings, kCostRingPoints);
    const double point_area = surface_area(capsule) / static_cast<double>(points.size());
    for (const Vec3& point : points) {
      if (union_signed_distance(capsules, point) < -kOuterDepth_m) continue;
      const double distance = voxels.outside_distance(point);
      sum += point_area * distance * distance;
      outer_area += point_area;
    }
  }
  return outer_area > 0 ? sum / outer_area : 0;
}

}  // namespace morphe::cover
