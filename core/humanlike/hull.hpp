#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// Facets of the convex hull of points: three indices each, counter-clockwise from outside. Four
/// points are a tetrahedron, more go through Quickhull; none if they are fewer, or flat.
std::vector<std::array<std::size_t, 3>> hull_facets(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
