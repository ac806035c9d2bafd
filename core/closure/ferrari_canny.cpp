#include "core/closure/ferrari_canny.hpp"

#include <algorithm>

#include "core/closure/least_ratio.hpp"
#include "core/closure/nearest_point.hpp"

namespace morphe::closure {
namespace {

FerrariCanny zero_for(const Wrench& null_twist) {
  return {.weakest_twist = null_twist, .exactly_zero = true, .within_tolerance = true};
}

}  // namespace

FerrariCanny ferrari_canny(const ContactSet& contacts, ForceLimit limit,
                           const BoundTolerance& tolerance) {
  if (contacts.contacts.empty()) return zero_for(Wrench::Unit(0));
  const WrenchSet hull = make_wrench_set(contacts, ForceLimit::sum);
  const Bounds depth = negative_origin_distance(hull, tolerance);
  if (depth.upper < -hull.rounding) {
    // A plane separates 0 from the wrench set, so each contact pushes away from `direction`.
    if (limit == ForceLimit::each) return zero_for(depth.direction);
    return {.lower = depth.lower,
            .upper = depth.upper,
            .weakest_twist = depth.direction,
            .within_tolerance = is_within_tolerance(depth, tolerance)};
  }
  Bounds known;
  known.lower = limit == ForceLimit::sum ? depth.lower : 0;
  const LeastRatio ratio = least_ratio(
      make_wrench_set(contacts, limit), [](const Wrench& u) { return u.norm(); }, tolerance, known);
  if (!ratio.flat.empty() && depth.lower > -8 * hull.rounding) return zero_for(ratio.flat.front());
  return {.lower = std::max(ratio.bounds.lower, known.lower),
          .upper = ratio.bounds.upper,
          .weakest_twist = ratio.bounds.direction,
          .within_tolerance = is_within_tolerance(ratio.bounds, tolerance),
          .insertions = ratio.insertions,
          .facets = ratio.facets};
}

}  // namespace morphe::closure
