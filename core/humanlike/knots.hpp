#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::humanlike {

/// A kinematic chain in the paper's common base frame, from the shoulder outwards [m]: the human's
/// shoulder, elbow and wrist, or the robot's joint centres, including shoulder and end.
using Chain = std::vector<Vec3>;

/// Returns the knots of a chain: the normalised arc length of each joint, 0 … 1. The chain must
/// have a positive length.
std::vector<double> knots(const Chain& chain);

/// Returns the union of both chains' knots in order, each once (within 1e-12).
std::vector<double> all_knots(const std::vector<double>& first, const std::vector<double>& second);

/// The position of a knot on a chain: at the parameter `share` of the link from end - 1 to `end`.
struct ChainPoint {
  std::ptrdiff_t end = 1;
  double share = 0;  ///< 0 … 1

  /// Returns the point at this position.
  Vec3 point_on(const Chain& chain) const {
    return (1 - share) * chain[end - 1] + share * chain[end];
  }
};
/// Returns the position of a knot, given the chain's own knots.
ChainPoint chain_point(const std::vector<double>& knots, double knot);

}  // namespace morphe::humanlike
