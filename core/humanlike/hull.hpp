#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// Returns the facets of the convex hull of points: three indices each, counter-clockwise from
/// outside. Four points form a tetrahedron, more are passed to math::convex_hull_3d; the result is
/// empty for fewer or coplanar points.
std::vector<std::array<std::size_t, 3>> hull_facets(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
