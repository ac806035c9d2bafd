#include "core/closure/least_ratio.hpp"

#include <queue>

#include "core/closure/general_position.hpp"
#include "core/closure/growing_polytope.hpp"

namespace morphe::closure {
namespace {

/// A facet's place in the queue: the least ratio first, the oldest of equals.
struct Rank {
  double ratio;
  std::int32_t facet;

  bool operator<(const Rank& other) const {
    return ratio != other.ratio ? ratio > other.ratio : facet > other.facet;
  }
};

}  // namespace

LeastRatio least_ratio(const WrenchSet& set, const Gauge& gauge, const Tolerance& tolerance,
                       const Bounds& known) {
  LeastRatio found;
  Bounds& bounds = found.bounds;
  bounds = known;
  const auto ask = [&](double height, const Wrench& u) {
    const double g = gauge(u);
    if (g > kAlong) bounds.ask((height + set.evaluation()) / g, u);
  };
  const GeneralPosition start = general_position(set);
  found.flat = start.flat;
  for (std::size_t k = 0; k < start.asked.size(); ++k) ask(start.heights[k], start.asked[k]);
  if (near_enough(bounds, tolerance) || start.corners.size() < 2) return found;

  GrowingPolytope polytope(start.corners);
  if (!polytope.proper()) return found;
  const std::vector<GrowingPolytope::Facet>& facets = polytope.facets();
  std::priority_queue<Rank> queue;
  std::int32_t ranked = 0;
  while (true) {
    for (; ranked < static_cast<std::int32_t>(facets.size()); ++ranked) {
      const GrowingPolytope::Facet& facet = facets[static_cast<std::size_t>(ranked)];
      const double g = gauge(facet.normal), distance = facet.distance - set.rounding;
      if (g > kAlong) {
        queue.push({distance / g, ranked});
      } else if (facet.distance < -set.rounding) {
        queue.push({-kInfinity, ranked});
      }
    }
    while (!queue.empty() && !facets[static_cast<std::size_t>(queue.top().facet)].alive)
      queue.pop();
    if (queue.empty()) break;
    const Rank least = queue.top();
    if (least.ratio > 0) bounds.lower = std::max(bounds.lower, least.ratio);
    if (near_enough(bounds, tolerance) || found.insertions >= tolerance.most_insertions) break;
    const Wrench u = facets[static_cast<std::size_t>(least.facet)].normal;
    const Support there = support(set, u);
    ask(there.value, u);
    if (near_enough(bounds, tolerance)) break;
    if (!polytope.insert(there.point, least.facet, 0.1 * set.rounding)) break;
    ++found.insertions;
  }
  for (const GrowingPolytope::Facet& facet : facets) found.facets += facet.alive ? 1 : 0;
  return found;
}

}  // namespace morphe::closure
