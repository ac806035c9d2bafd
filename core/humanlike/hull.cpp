#include "core/humanlike/hull.hpp"

#include <algorithm>
#include <utility>

#include "core/math/convex_hull_3d.hpp"

namespace morphe::humanlike {
namespace {

using Facet = std::array<int, 3>;

/// Returns the indices of the points that differ from all points before them.
std::vector<int> distinct_indices(const std::vector<Vec3>& points) {
  std::vector<int> kept;
  for (int i = 0; i < std::ssize(points); ++i) {
    const auto same = [&](int other) { return (points[i] - points[other]).norm() < 1e-12; };
    if (std::ranges::none_of(kept, same)) kept.push_back(i);
  }
  return kept;
}

/// Returns the facets of the tetrahedron of the points i[0] … i[3]; empty if they are coplanar.
std::vector<Facet> tetrahedron(const std::vector<Vec3>& points, const std::vector<int>& i) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = points[i[k + 1]] - points[i[0]];
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
  const std::vector<int> corners = distinct_indices(points);
  if (corners.size() < 4) return {};
  if (corners.size() == 4) return tetrahedron(points, corners);
  std::vector<Vec3> distinct_points;
  for (const int corner : corners) distinct_points.push_back(points[corner]);
  std::vector<Facet> facets;
  for (const math::HullTriangle& triangle : math::convex_hull_3d(std::move(distinct_points))) {
    Facet facet;
    for (int k = 0; k < 3; ++k) facet[k] = corners[triangle.corners[k]];
    const Vec3 normal =
        (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]);
    if (normal.dot(triangle.outwards) < 0) std::swap(facet[1], facet[2]);
    facets.push_back(facet);
  }
  return facets;
}

}  // namespace morphe::humanlike
