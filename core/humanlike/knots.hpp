#pragma once

#include <vector>

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// Returns the normalised arc length of each joint of a chain, 0 … 1.
std::vector<double> knots(const Chain& chain);

/// Returns the union of both chains' knots in order, without repetition.
std::vector<double> all_knots(const std::vector<double>& first, const std::vector<double>& second);

/// The position of a knot on a chain: between the joints end - 1 and end, at the parameter `share`.
struct ChainPoint {
  std::size_t end = 1;
  double share = 0;

  /// Returns the point at this position.
  Vec3 point_on(const Chain& chain) const {
    return (1 - share) * chain[end - 1] + share * chain[end];
  }
};
/// Returns the position of a knot, given the chain's own knots.
ChainPoint chain_point(const std::vector<double>& at, double knot);

}  // namespace morphe::humanlike
