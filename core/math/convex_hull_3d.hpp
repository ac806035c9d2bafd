#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// A triangle of the convex hull of points.
struct HullTriangle {
  std::array<int, 3> corners{};     ///< indices of points, clockwise or counterclockwise
  Vec3 outwards = unknown_point();  ///< unit normal of the facet
};

/// Returns the triangles of the convex hull of points in qhull's order, facets with more corners
/// cut into triangles. Empty where qhull finds no hull: for fewer than four or coplanar points.
std::vector<HullTriangle> convex_hull_3d(std::vector<Vec3> points);

}  // namespace morphe::math
