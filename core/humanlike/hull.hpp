#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// Returns the facets of the convex hull of points, each as the indices of its three corners,
/// counter-clockwise seen from outside; empty if the points are fewer than four or coplanar.
std::vector<std::array<int, 3>> hull_facets(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
