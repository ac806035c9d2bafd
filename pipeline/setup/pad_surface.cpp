#include "pipeline/setup/pad_surface.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/setup/finger_bodies.hpp"

namespace morphe::setup {

double end_along(const std::vector<Vec3>& points, const Vec3& from, const Vec3& direction) {
  double end_m = -HUGE_VAL;
  for (const Vec3& point : points) end_m = std::max(end_m, (point - from).dot(direction));
  return end_m;
}

Vec3 pad_surface(const std::vector<Vec3>& points, const Vec3& from, const Vec3& bone,
                 const Vec3& normal, double end_m) {
  double height = -HUGE_VAL;
  const double station = end_m - std::min(kPadSetback_m, 0.3 * end_m);
  const Vec3 side = bone.cross(normal);
  double min_side = HUGE_VAL, max_side = -HUGE_VAL;
  for (const Vec3& point : points) {
    if ((point - from).dot(bone) < station - kPadSetback_m) continue;
    height = std::max(height, (point - from).dot(normal));
    min_side = std::min(min_side, (point - from).dot(side));
    max_side = std::max(max_side, (point - from).dot(side));
  }
  return from + station * bone + height * normal + 0.5 * (min_side + max_side) * side;
}

Pose make_frame(const Vec3& origin, const Vec3& x, const Vec3& z) {
  Pose pose = Pose::Identity();
  pose.translation() = origin;
  pose.linear().col(2) = z.normalized();
  pose.linear().col(0) = perpendicular_part(x, pose.linear().col(2)).normalized();
  pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
  return pose;
}

}  // namespace morphe::setup
