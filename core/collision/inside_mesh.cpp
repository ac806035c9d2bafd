#include <algorithm>
#include <cmath>
#include <optional>

#include "core/collision/constants.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

/// Unit vectors that are unlikely to be parallel to an edge or a face.
const Vec3 kDirections[] = {{0.5377, 0.8339, 0.1259},   {-0.3188, 0.2276, 0.9202},
                            {0.8622, -0.4336, 0.2625},  {-0.7447, -0.6312, 0.2163},
                            {0.1419, -0.3542, -0.9244}, {-0.1241, 0.4897, -0.8630}};

bool ray_meets(const MeshSolid::Node& node, const Vec3& from, const Vec3& inverse) {
  const Vec3 one = (node.low - from).cwiseProduct(inverse);
  const Vec3 other = (node.high - from).cwiseProduct(inverse);
  const double enter = one.cwiseMin(other).maxCoeff(), leave = one.cwiseMax(other).minCoeff();
  return leave >= std::max(enter, 0.0);
}

enum class Hit { no, yes, grazing };

/// Intersects a ray with a triangle by the algorithm of Moeller and Trumbore.
Hit ray_hits(const MeshSolid::Triangle& t, const Vec3& from, const Vec3& direction) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, across = direction.cross(ac), from_a = from - t.a;
  const double volume = ab.dot(across), size = ab.norm() * ac.norm();
  if (std::abs(volume) <= 1e-12 * size) {
    // A triangle that is parallel to the ray or degenerate is grazed if the ray is in its plane.
    const double height = ab.cross(ac).dot(from_a);
    return size > 0 && std::abs(height) <= kGrazingTolerance * size ? Hit::grazing : Hit::no;
  }
  const double u = from_a.dot(across) / volume;
  const Vec3 cross = from_a.cross(ab);
  const double v = direction.dot(cross) / volume, along = ac.dot(cross) / volume;
  const double min_barycentric = std::min({u, v, 1 - u - v});
  if (min_barycentric < -kGrazingTolerance || along < 0) return Hit::no;
  return min_barycentric < kGrazingTolerance ? Hit::grazing : Hit::yes;
}

/// Returns true if a ray crosses a closed part an odd number of times, nullopt if it grazes one.
std::optional<bool> has_odd_crossings(const MeshSolid& mesh, const Vec3& point,
                                      const Vec3& direction) {
  const Vec3 inverse = direction.cwiseInverse();
  std::vector<int> stack = {0}, parts;
  while (!stack.empty()) {
    const MeshSolid::Node& node = mesh.nodes[stack.back()];
    stack.pop_back();
    if (!ray_meets(node, point, inverse)) continue;
    if (node.count == 0) {
      stack.push_back(node.left);
      stack.push_back(node.right);
    }
    for (int k = node.first; k < node.first + node.count; ++k) {
      const MeshSolid::Triangle& triangle = mesh.triangles[k];
      if (!mesh.closed[triangle.part]) continue;
      const Hit hit = ray_hits(triangle, point, direction);
      if (hit == Hit::grazing) return std::nullopt;
      if (hit == Hit::yes) parts.push_back(triangle.part);
    }
  }
  std::ranges::sort(parts);
  for (auto part = parts.begin(); part != parts.end();) {
    const auto next = std::upper_bound(part, parts.end(), *part);
    if ((next - part) % 2 == 1) return true;
    part = next;
  }
  return false;
}

}  // namespace

bool is_inside(const MeshSolid& mesh, const Vec3& point) {
  if (mesh_distance_lower_bound(mesh, point) > 0) return false;
  for (const Vec3& direction : kDirections) {
    if (const std::optional<bool> odd = has_odd_crossings(mesh, point, direction)) return *odd;
  }
  return true;  // every ray grazes a part: the point is practically on the surface
}

}  // namespace morphe::collision
