#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe::math {

/// Returns the vertices of the convex hull of points in a plane (Andrew 1979), counter-clockwise if
/// y points up; fewer than three if the points are collinear.
std::vector<Eigen::Vector2d> convex_hull_2d(std::vector<Eigen::Vector2d> points);

}  // namespace morphe::math
