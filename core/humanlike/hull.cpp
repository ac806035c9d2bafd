#include "core/humanlike/hull.hpp"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace morphe::humanlike {
namespace {

using Facet = std::array<std::size_t, 3>;

/// Returns the indices of the points that differ from all points before them.
std::vector<std::size_t> distinct(const std::vector<Vec3>& points) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](std::size_t other) {
      return (points[i] - points[other]).norm() < 1e-12;
    });
    if (!known) kept.push_back(i);
  }
  return kept;
}

std::vector<Facet> tetrahedron(const std::vector<Vec3>& points, const std::vector<std::size_t>& i) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
    edges.col(k) = points[i[static_cast<std::size_t>(k) + 1]] - points[i[0]];
  const double determinant = edges.determinant();
  if (determinant == 0) return {};
  std::vector<Facet> facets{
      {i[0], i[2], i[1]}, {i[0], i[1], i[3]}, {i[0], i[3], i[2]}, {i[1], i[2], i[3]}};
  if (determinant < 0) {
    for (Facet& facet : facets) std::swap(facet[1], facet[2]);
  }
  return facets;
}

}  // namespace

std::vector<Facet> hull_facets(const std::vector<Vec3>& points) {
  const std::vector<std::size_t> corners = distinct(points);
  if (corners.size() < 4) return {};
  if (corners.size() == 4) return tetrahedron(points, corners);
  std::vector<double> coordinates;
  for (const std::size_t corner : corners) {
    coordinates.insert(coordinates.end(), points[corner].begin(), points[corner].end());
  }
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qhT* qh = &hull;  // name required by qhull's macros
  qh_zero(qh, silence);
  char command[] = "qhull Qt";
  std::vector<Facet> facets;
  // Quickhull fails for coplanar sets, which have no facets in space.
  if (!qh_new_qhull(qh, 3, static_cast<int>(corners.size()), coordinates.data(), 0, command,
                    silence, silence)) {
    facetT* facet;
    FORALLfacets {
      std::vector<std::size_t> corner;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(facet->vertices) {
        corner.push_back(corners[static_cast<std::size_t>(qh_pointid(qh, vertex->point))]);
      }
      const Vec3 outwards(facet->normal[0], facet->normal[1], facet->normal[2]);
      const Vec3 normal =
          (points[corner[1]] - points[corner[0]]).cross(points[corner[2]] - points[corner[0]]);
      if (normal.dot(outwards) < 0) std::swap(corner[1], corner[2]);
      facets.push_back({corner[0], corner[1], corner[2]});
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  if (silence) std::fclose(silence);
  return facets;
}

}  // namespace morphe::humanlike
