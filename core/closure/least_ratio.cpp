#include "core/closure/least_ratio.hpp"

#include <queue>

#include "core/closure/incremental_hull.hpp"
#include "core/closure/initial_simplex.hpp"

namespace morphe::closure {
namespace {

/// A facet's position in the queue: the smallest ratio first, the oldest of equals.
struct Rank {
  double ratio;
  std::int32_t facet;

  bool operator<(const Rank& other) const {
    return ratio != other.ratio ? ratio > other.ratio : facet > other.facet;
  }
};

}  // namespace

LeastRatio least_ratio(const WrenchSet& set, const Gauge& gauge, const BoundTolerance& tolerance,
                       const Bounds& known) {
  LeastRatio found;
  Bounds& bounds = found.bounds;
  bounds = known;
  const auto ask = [&](double height, const Wrench& u) {
    const double g = gauge(u);
    if (g > kGaugeTolerance) bounds.update_upper((height + set.support_error()) / g, u);
  };
  const InitialSimplex start = initial_simplex(set);
  found.flat = start.flat_directions;
  for (std::size_t k = 0; k < start.queried_directions.size(); ++k)
    ask(start.support_values[k], start.queried_directions[k]);
  if (is_within_tolerance(bounds, tolerance) || start.vertices.size() < 2) return found;

  IncrementalHull polytope(start.vertices);
  if (!polytope.is_proper()) return found;
  const std::vector<IncrementalHull::Facet>& facets = polytope.facets();
  std::priority_queue<Rank> queue;
  std::int32_t ranked = 0;
  while (true) {
    for (; ranked < static_cast<std::int32_t>(facets.size()); ++ranked) {
      const IncrementalHull::Facet& facet = facets[ranked];
      const double g = gauge(facet.normal), distance = facet.distance - set.rounding;
      if (g > kGaugeTolerance) {
        queue.push({distance / g, ranked});
      } else if (facet.distance < -set.rounding) {
        queue.push({-kInfinity, ranked});
      }
    }
    while (!queue.empty() && !facets[queue.top().facet].alive) queue.pop();
    if (queue.empty()) break;
    const Rank least = queue.top();
    if (least.ratio > 0) bounds.lower = std::max(bounds.lower, least.ratio);
    if (is_within_tolerance(bounds, tolerance) || found.insertions >= tolerance.max_insertions)
      break;
    const Wrench u = facets[least.facet].normal;
    const Support there = support(set, u);
    ask(there.value, u);
    if (is_within_tolerance(bounds, tolerance)) break;
    if (!polytope.insert(there.point, least.facet, 0.1 * set.rounding)) break;
    ++found.insertions;
  }
  for (const IncrementalHull::Facet& facet : facets) found.facets += facet.alive ? 1 : 0;
  return found;
}

}  // namespace morphe::closure
