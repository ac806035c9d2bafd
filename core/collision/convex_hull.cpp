#include "core/collision/convex_hull.hpp"

#include <libqhull_r/qhull_ra.h>

#include <cstdio>
#include <map>

namespace morphe::collision {
namespace {

/// Returns the triangles of the hull by point, with arbitrary orientation.
std::vector<Eigen::Vector3i> hull_triangles(std::vector<Vec3>& points) {
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qhT* qh = &hull;  // name required by qhull's macros
  qh_zero(qh, silence);
  char command[] = "qhull Qt";
  std::vector<Eigen::Vector3i> triangles;
  if (!qh_new_qhull(qh, 3, static_cast<int>(points.size()), points.front().data(), 0, command,
                    silence, silence)) {
    facetT* facet;
    FORALLfacets {
      Eigen::Vector3i triangle;
      int corner = 0;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(facet->vertices) triangle[corner++] = qh_pointid(qh, vertex->point);
      triangles.push_back(triangle);
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  if (silence) std::fclose(silence);
  return triangles;
}

}  // namespace

bool replace_by_convex_hull(SceneObject& mesh) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  std::vector<Eigen::Vector3i> triangles = hull_triangles(mesh.vertices);
  if (triangles.empty()) return false;
  std::map<int, int> kept;
  std::vector<Vec3> vertices;
  for (Eigen::Vector3i& triangle : triangles) {
    for (int& corner : triangle) {
      const auto [place, added] = kept.emplace(corner, static_cast<int>(vertices.size()));
      if (added) vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
      corner = place->second;
    }
  }
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  return true;
}

}  // namespace morphe::collision
