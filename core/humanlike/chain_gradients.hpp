#pragma once

#include <vector>

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// The value of a metric of two chains and its gradient with respect to the joints of the robot's
/// chain.
struct ChainGradient {
  double value = 0;
  std::vector<Vec3> gradient;     ///< with respect to each joint
  std::vector<double> curvature;  ///< approximate upper bound for each joint, 0 if unknown
};

/// Computes metric B, Eq. (6) [m²], with the area of each triangle smoothed at zero to sqrt(area² +
/// e²) - e. Virtual joints move with the link lengths. The metric is not differentiable if knots of
/// both chains coincide.
ChainGradient triangle_area_gradient(const Chain& human, const Chain& robot, double smoothing_m2);

/// Computes metric C, Eqs. (7)–(9) [m³]: a facet (a, b, c), counter-clockwise from outside,
/// contributes a · (b × c) / 6 to the volume of its hull. The metric is not differentiable if a
/// joint enters a hull or changes its facets.
ChainGradient hull_volume_gradient(const Chain& human, const Chain& robot);

/// Computes the volume of the convex hull of points and its gradient with respect to each point;
/// both are zero if the points are coplanar.
ChainGradient hull_gradient(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
