#include "core/closure/ferrari_canny.hpp"

#include <algorithm>

#include "core/closure/least_ratio.hpp"
#include "core/closure/nearest_point.hpp"

namespace morphe::closure {
namespace {

FerrariCanny zero(const Wrench& null) {
  FerrariCanny found;
  found.weakest_twist = null;
  found.exactly_zero = found.within_tolerance = true;
  return found;
}

}  // namespace

FerrariCanny ferrari_canny(const ContactSet& contacts, ForceLimit limit,
                           const BoundTolerance& tolerance) {
  if (contacts.contacts.empty()) return zero(Wrench::Unit(0));
  const WrenchSet hull = make_wrench_set(contacts, ForceLimit::sum);
  const Bounds below = negative_origin_distance(hull, tolerance);
  if (below.upper < -hull.rounding) {
    // A plane separates 0 from the wrench set, so each contact pushes away from `direction`.
    if (limit == ForceLimit::each) return zero(below.direction);
    FerrariCanny open;
    open.lower = below.lower;
    open.upper = below.upper;
    open.weakest_twist = below.direction;
    open.within_tolerance = is_within_tolerance(below, tolerance);
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
  found.weakest_twist = least.bounds.direction;
  found.within_tolerance = is_within_tolerance(least.bounds, tolerance);
  found.insertions = least.insertions;
  found.facets = least.facets;
  return found;
}

}  // namespace morphe::closure
