#pragma once

#include <vector>

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// Normalised arc length of each joint of a chain, 0 … 1.
std::vector<double> knots(const Chain& chain);

/// The union of both chains' knots in order, without repetition.
std::vector<double> all_knots(const std::vector<double>& first, const std::vector<double>& second);

/// Where a knot lies: between the joints end - 1 and end, `share` of the way.
struct ChainPoint {
  std::size_t end = 1;
  double share = 0;

  Vec3 on(const Chain& chain) const { return (1 - share) * chain[end - 1] + share * chain[end]; }
};
ChainPoint chain_point(const std::vector<double>& at, double knot);

}  // namespace morphe::humanlike
