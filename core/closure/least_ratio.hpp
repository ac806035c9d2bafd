#pragma once

#include <functional>
#include <vector>

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// A gauge g(u) >= 0, with g(s u) = s g(u) for s > 0.
using Gauge = std::function<double(const Wrench&)>;

/// g(u) of a unit vector counts as 0 up to this value, so that a facet whose normal is nearly in
/// the kernel of g does not end the search.
inline constexpr double kGaugeTolerance = 1e-9;

/// The smallest h(u) / g(u) over all u with g(u) > 0, which measures the extent of a set of
/// wrenches.
struct LeastRatio {
  Bounds bounds;
  /// Directions in which the set is flat; they are excluded from the search.
  std::vector<Wrench> flat;
  int insertions = 0;  ///< number of insertions into the polytope
  int facets = 0;      ///< final number of facets of the polytope
};

/// Computes the least ratio. A polytope grows inside the set (incremental_hull.hpp): each facet's
/// distance / g(normal) is a lower bound for the twists of this facet, and the smallest of them is
/// a lower bound for all. For the facet with the smallest one, the support point in its normal
/// direction gives an upper bound, h(u) / g(u), and is inserted, until both bounds are close
/// enough, no point is beyond the facet, or the insertions are used up; the bounds then remain
/// apart. `known` contains bounds known before, because the polytope gives no bounds below 0 if 0
/// is outside.
LeastRatio least_ratio(const WrenchSet& set, const Gauge& gauge, const BoundTolerance& tolerance,
                       const Bounds& known);

}  // namespace morphe::closure
