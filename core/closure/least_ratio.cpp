#include "core/closure/least_ratio.hpp"

#include <queue>

#include "core/closure/incremental_hull.hpp"
#include "core/closure/initial_simplex.hpp"

namespace morphe::closure {
namespace {

/// A facet's position in the queue: the smallest ratio first, the oldest of equals.
struct Rank {
  double ratio;
  int facet;

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
  const auto update_upper = [&](double height, const Wrench& u) {
    const double g = gauge(u);
    if (g > kGaugeTolerance) bounds.update_upper((height + set.support_error()) / g, u);
  };
  const InitialSimplex start = initial_simplex(set);
  found.flat = start.flat_directions;
  for (int k = 0; k < std::ssize(start.queried_directions); ++k)
    update_upper(start.support_values[k], start.queried_directions[k]);
  if (is_within_tolerance(bounds, tolerance) || start.vertices.size() < 2) return found;

  IncrementalHull polytope(start.vertices);
  if (!polytope.is_proper()) return found;
  const std::vector<IncrementalHull::Facet>& facets = polytope.facets();
  std::priority_queue<Rank> queue;
  int ranked = 0;
  while (true) {
    for (; ranked < std::ssize(facets); ++ranked) {
      const IncrementalHull::Facet& facet = facets[ranked];
      const double g = gauge(facet.normal), distance = facet.distance - set.rounding;
      if (g > kGaugeTolerance)
        queue.push({distance / g, ranked});
      else if (facet.distance < -set.rounding)
        queue.push({-kInfinity, ranked});
    }
    while (!queue.empty() && !facets[queue.top().facet].alive) queue.pop();
    if (queue.empty()) break;
    const Rank top = queue.top();
    if (top.ratio > 0) bounds.lower = std::max(bounds.lower, top.ratio);
    if (is_within_tolerance(bounds, tolerance) || found.insertions >= tolerance.max_insertions)
      break;
    const Wrench u = facets[top.facet].normal;
    const Support farthest = support(set, u);
    update_upper(farthest.value, u);
    if (is_within_tolerance(bounds, tolerance)) break;
    if (!polytope.insert(farthest.point, top.facet, 0.1 * set.rounding)) break;
    ++found.insertions;
  }
  for (const IncrementalHull::Facet& facet : facets) found.facets += facet.alive ? 1 : 0;
  return found;
}

}  // namespace morphe::closure
