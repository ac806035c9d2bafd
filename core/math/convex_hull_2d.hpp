#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe::math {

/// Returns the convex hull of points in a plane, counter-clockwise if y points up (Andrew 1979); it
/// has fewer than three vertices if the points are collinear.
std::vector<Eigen::Vector2d> convex_hull_2d(std::vector<Eigen::Vector2d> points);

}  // namespace morphe::math
