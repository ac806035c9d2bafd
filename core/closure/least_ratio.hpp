#pragma once

#include <functional>
#include <vector>

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// g(u) >= 0, with g(s u) = s g(u) for s > 0.
using Gauge = std::function<double(const Wrench&)>;

/// g(u) of a unit vector counts as 0 up to this: a facet that all but holds the way asked about
/// does not end it.
inline constexpr double kAlong = 1e-9;

/// The least h(u) / g(u) over all u with g(u) > 0, which tells how far a set of wrenches reaches.
struct LeastRatio {
  Bounds bounds;
  std::vector<Wrench> flat;  ///< where the set has no width; the search is in what is left
  int insertions = 0;        ///< into the polytope
  int facets = 0;            ///< of it, in the end
};

/// A polytope grows inside the set (growing_polytope.hpp): each facet's distance / g(normal) is a
/// lower bound of what lies behind it, and the least of them a lower bound of all. Where that is,
/// the support point in the facet's normal gives an upper bound, h(u) / g(u), and is inserted,
/// until both are near enough, no point lies beyond the facet, or the insertions are used up: then
/// the bounds are as far apart as they say. `known` holds what is known before: the polytope tells
/// nothing below 0, where 0 is outside.
LeastRatio least_ratio(const WrenchSet& set, const Gauge& gauge, const Tolerance& tolerance,
                       const Bounds& known);

}  // namespace morphe::closure
