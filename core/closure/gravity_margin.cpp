#include "core/closure/gravity_margin.hpp"

#include <algorithm>

#include "core/closure/least_ratio.hpp"

namespace morphe::closure {
namespace {

/// Margins, and powers of gravity in a twist, below this are rounding and count as zero.
constexpr double kMarginTolerance = 1e-9;

Vec3 velocity_of(const Vec3& r, const Wrench& u) {
  return u.head<3>() + Vec3(u.tail<3>()).cross(r);
}

GravityMargin margin_of(const ContactSet& contacts, const Gauge& gauge,
                        const BoundTolerance& tolerance) {
  GravityMargin margin;
  margin.within_tolerance = true;
  if (contacts.contacts.empty()) return margin;
  Bounds known;
  known.lower = 0;
  const LeastRatio ratio =
      least_ratio(make_wrench_set(contacts, ForceLimit::each), gauge, tolerance, known);
  margin.insertions = ratio.insertions;
  margin.facets = ratio.facets;
  Bounds bounds = ratio.bounds;
  // The lower bound holds for the directions in which the set is not flat.
  for (const Wrench& flat : ratio.flat)
    if (std::max(gauge(flat), gauge(-flat)) > kMarginTolerance) bounds.lower = 0;
  margin.lower = bounds.lower < kMarginTolerance ? 0 : bounds.lower;
  margin.upper = bounds.upper < kMarginTolerance ? 0 : bounds.upper;
  margin.weakest = bounds.direction;
  margin.within_tolerance = is_within_tolerance(bounds, tolerance);
  return margin;
}

}  // namespace

double GravityMargin::sufficient_force_n(double mass_kg) const {
  return lower > 0 ? kGravity_m_s2 * mass_kg / lower : kInfinity;
}

GravityMargin gravity_margin(const ContactSet& contacts, const Load& load, const Vec3& gravity,
                             const BoundTolerance& tolerance) {
  const Vec3 down = gravity.normalized();
  const Vec3 r = (load.centre_of_mass - contacts.reference) / contacts.torque_scale_m;
  const Wrench weight = wrench_of(down, r);
  GravityMargin margin = margin_of(
      contacts, [&](const Wrench& u) { return std::max(0.0, -u.dot(weight)); }, tolerance);
  margin.direction = down;
  return margin;
}

GravityMargin worst_gravity_margin(const ContactSet& contacts, const Load& load,
                                   const BoundTolerance& tolerance) {
  const Vec3 r = (load.centre_of_mass - contacts.reference) / contacts.torque_scale_m;
  GravityMargin margin = margin_of(
      contacts, [&](const Wrench& u) { return velocity_of(r, u).norm(); }, tolerance);
  margin.direction = -velocity_of(r, margin.weakest).normalized();
  return margin;
}

}  // namespace morphe::closure
