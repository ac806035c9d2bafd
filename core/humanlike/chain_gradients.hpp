#pragma once

#include <vector>

#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {

/// The value of a metric of two chains and its gradient with respect to the robot's joints.
struct ChainGradient {
  double value = 0;
  std::vector<Vec3> gradient;     ///< [joints]
  std::vector<double> curvature;  ///< [joints] approximate upper bound, in any direction; or 0
};

/// Computes metric B, Eq. (6) [m²], with the area of each triangle smoothed at zero to sqrt(area² +
/// e²) - e, e = smoothing_m2. The gradient includes that the knots, and with them the virtual
/// joints, move with the link lengths. The metric is not differentiable if knots of both chains
/// coincide.
ChainGradient triangle_area_gradient(const Chain& human, const Chain& robot, double smoothing_m2);

/// Computes metric C, Eqs. (7)–(9) [m³], see hull_volume_sum(). The human's chain is shoulder,
/// elbow, wrist. The metric is not differentiable where a joint enters a hull or changes its
/// facets.
ChainGradient hull_volume_gradient(const Chain& human, const Chain& robot);

/// Computes the volume of the convex hull of points [m³] and its gradient with respect to each
/// point: a facet (a, b, c), counter-clockwise from outside, contributes a · (b × c) / 6. Both are
/// zero if the points are coplanar.
ChainGradient hull_gradient(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
