#include "core/closure/ferrari_canny.hpp"

#include <algorithm>

#include "core/closure/least_ratio.hpp"
#include "core/closure/nearest_point.hpp"

namespace morphe::closure {
namespace {

FerrariCanny zero(const Wrench& null) {
  FerrariCanny found;
  found.weakest = null;
  found.exactly_zero = found.within_tolerance = true;
  return found;
}

}  // namespace

FerrariCanny ferrari_canny(const ContactSet& contacts, ForceLimit limit,
                           const Tolerance& tolerance) {
  if (contacts.contacts.empty()) return zero(Wrench::Unit(0));
  const WrenchSet hull = make_wrench_set(contacts, ForceLimit::sum);
  const Bounds below = distance_below_zero(hull, tolerance);
  if (below.upper < -hull.rounding) {
    // A plane parts 0 from what the contacts can do together, so each pushes away from `direction`.
    if (limit == ForceLimit::each) return zero(below.direction);
    FerrariCanny open;
    open.lower = below.lower;
    open.upper = below.upper;
    open.weakest = below.direction;
    open.within_tolerance = near_enough(below, tolerance);
    return open;
  }
  Bounds known;
  known.lower = limit == ForceLimit::sum ? below.lower : 0;
  const LeastRatio least = least_ratio(
      make_wrench_set(contacts, limit), [](const Wrench& u) { return u.norm(); }, tolerance, known);
  if (!least.flat.empty() && below.lower > -8 * hull.rounding) return zero(least.flat.front());
  FerrariCanny found;
  found.lower = std::max(least.bounds.lower, known.lower);
  found.upper = least.bounds.upper;
  found.weakest = least.bounds.direction;
  found.within_tolerance = near_enough(least.bounds, tolerance);
  found.insertions = least.insertions;
  found.facets = least.facets;
  return found;
}

}  // namespace morphe::closure
