#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// A triangle of the convex hull of points.
struct HullTriangle {
  std::array<std::size_t, 3> corners{};  ///< indices of points, clockwise or counterclockwise
  Vec3 outwards = unknown_point();       ///< unit normal of the facet
};

/// Returns the triangles of the convex hull of points in the order of qhull, which also divides
/// facets with more corners into triangles. The result is empty where qhull finds no hull: for
/// fewer than four or coplanar points.
std::vector<HullTriangle> convex_hull_3d(std::vector<Vec3> points);

}  // namespace morphe::math
