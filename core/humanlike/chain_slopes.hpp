#pragma once

#include <vector>

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// A metric of two chains with its slope by each joint of the robot's chain.
struct ChainSlopes {
  double value = 0;
  std::vector<Vec3> slope;        ///< by each joint
  std::vector<double> curvature;  ///< of each, at most about; 0: none known
};

/// Metric B, Eq. (6) [m²], each triangle's area rounded off at zero to sqrt(area² + e²) - e.
/// Virtual joints move with the link lengths. Kinks remain where knots of both chains meet.
ChainSlopes triangle_area_slopes(const Chain& human, const Chain& robot, double smoothing_m2);

/// Metric C, Eqs. (7)–(9) [m³]: a facet (a, b, c), counter-clockwise from outside, has the share
/// a · (b × c) / 6 in its hull's volume. Kinks remain where a joint enters a hull or changes it.
ChainSlopes hull_volume_slopes(const Chain& human, const Chain& robot);

/// Volume of the hull of points, with its slope by each of them; zero where they are flat.
ChainSlopes hull_slopes(const std::vector<Vec3>& points);

}  // namespace morphe::humanlike
