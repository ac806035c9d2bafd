#include "core/collision/convex_hull.hpp"

#include <map>
#include <utility>

#include "core/math/convex_hull_3d.hpp"

namespace morphe::collision {

bool replace_by_convex_hull(SceneObject& mesh) {
  const std::vector<math::HullTriangle> hull = math::convex_hull_3d(mesh.vertices);
  if (hull.empty()) return false;
  std::map<std::size_t, int> kept;
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (const math::HullTriangle& facet : hull) {
    Eigen::Vector3i& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = facet.corners[k];
      const auto [place, added] = kept.emplace(corner, static_cast<int>(vertices.size()));
      if (added) vertices.push_back(mesh.vertices[corner]);
      triangle[k] = place->second;
    }
  }
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  return true;
}

}  // namespace morphe::collision
