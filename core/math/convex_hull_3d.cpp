#include "core/math/convex_hull_3d.hpp"

#include <libqhull_r/qhull_ra.h>

#include <cstdio>

namespace morphe::math {

std::vector<HullTriangle> convex_hull_3d(std::vector<Vec3> points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (points.empty()) return {};
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qhT* qh = &hull;  // name required by qhull's macros
  qh_zero(qh, silence);
  char command[] = "qhull Qt";
  std::vector<HullTriangle> triangles;
  if (!qh_new_qhull(qh, 3, static_cast<int>(points.size()), points.front().data(), 0, command,
                    silence, silence)) {
    facetT* facet;
    FORALLfacets {
      HullTriangle triangle;
      triangle.outwards = Vec3(facet->normal[0], facet->normal[1], facet->normal[2]);
      int corner = 0;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(facet->vertices) {
        if (corner == std::ssize(triangle.corners)) break;
        triangle.corners[corner++] = qh_pointid(qh, vertex->point);
      }
      triangles.push_back(triangle);
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  if (silence) std::fclose(silence);
  return triangles;
}

}  // namespace morphe::math
