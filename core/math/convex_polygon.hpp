#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe::math {

/// The least convex polygon around points of a plane, counterclockwise where y is up (Andrew 1979);
/// fewer than three corners where they lie on a line.
std::vector<Eigen::Vector2d> convex_polygon(std::vector<Eigen::Vector2d> points);

}  // namespace morphe::math
