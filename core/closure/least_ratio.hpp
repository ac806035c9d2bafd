#pragma once

#include <functional>
#include <vector>

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// A gauge g(u) >= 0, with g(s u) = s g(u) for s > 0.
using Gauge = std::function<double(const Wrench&)>;

/// g(u) of a unit vector up to this counts as 0: facets nearly in g's kernel do not end the search.
inline constexpr double kGaugeTolerance = 1e-9;

/// The smallest h(u) / g(u) over all u with g(u) > 0: a measure of the extent of a wrench set.
struct LeastRatio {
  Bounds bounds;
  std::vector<Wrench> flat;  ///< directions in which the set is flat; excluded from the search
  int insertions = 0;        ///< number of insertions into the polytope
  int facets = 0;            ///< final number of facets of the polytope
};

/// Computes the least ratio. A polytope grows inside the set (incremental_hull.hpp): each facet's
/// distance / g(normal) is a lower bound for the twists of this facet, and the smallest of them a
/// lower bound for all. For that facet, the support point in its normal direction gives an upper
/// bound, h(u) / g(u), and is inserted. The search ends if the bounds are close enough, if no point
/// is beyond the facet, or if the insertions are used up. `known` has bounds known before, because
/// the polytope gives only positive lower bounds.
LeastRatio least_ratio(const WrenchSet& set, const Gauge& gauge, const BoundTolerance& tolerance,
                       const Bounds& known);

}  // namespace morphe::closure
