#include "core/closure/gravity_margin.hpp"

#include <algorithm>

#include "core/closure/least_ratio.hpp"

namespace morphe::closure {
namespace {

/// Below this a margin, and what gravity does in a twist, is none: rounding makes as much.
constexpr double kNoMargin = 1e-9;

/// u_f + u_t × r.
Vec3 velocity_of(const Vec3& r, const Wrench& u) {
  return u.head<3>() + Vec3(u.tail<3>()).cross(r);
}

GravityMargin margin_of(const ContactSet& contacts, const Gauge& gauge,
                        const Tolerance& tolerance) {
  GravityMargin margin;
  margin.within_tolerance = true;
  if (contacts.contacts.empty()) return margin;
  Bounds known;
  known.lower = 0;
  const LeastRatio least =
      least_ratio(make_wrench_set(contacts, ForceLimit::each), gauge, tolerance, known);
  margin.insertions = least.insertions;
  margin.facets = least.facets;
  Bounds bounds = least.bounds;
  // Gravity acts where the set has no width: the lower bound is that of what is left without it.
  for (const Wrench& flat : least.flat) {
    if (std::max(gauge(flat), gauge(-flat)) > kNoMargin) bounds.lower = 0;
  }
  margin.lower = bounds.lower < kNoMargin ? 0 : bounds.lower;
  margin.upper = bounds.upper < kNoMargin ? 0 : bounds.upper;
  margin.weakest = bounds.direction;
  margin.within_tolerance = near_enough(bounds, tolerance);
  return margin;
}

}  // namespace

double GravityMargin::newtons_enough(double mass_kg) const {
  return lower > 0 ? kGravity * mass_kg / lower : kInfinity;
}

double GravityMargin::newtons_too_few(double mass_kg) const {
  return upper > 0 ? kGravity * mass_kg / upper : kInfinity;
}

GravityMargin gravity_margin(const ContactSet& contacts, const Load& load, const Vec3& gravity,
                             const Tolerance& tolerance) {
  const Vec3 down = gravity.normalized();
  const Vec3 r = (load.centre - contacts.reference) / contacts.torque_scale_m;
  const Wrench weight = wrench_of(down, r);
  GravityMargin margin = margin_of(
      contacts, [&](const Wrench& u) { return std::max(0.0, -u.dot(weight)); }, tolerance);
  margin.direction = down;
  return margin;
}

GravityMargin worst_gravity_margin(const ContactSet& contacts, const Load& load,
                                   const Tolerance& tolerance) {
  const Vec3 r = (load.centre - contacts.reference) / contacts.torque_scale_m;
  GravityMargin margin = margin_of(
      contacts, [&](const Wrench& u) { return velocity_of(r, u).norm(); }, tolerance);
  margin.direction = -velocity_of(r, margin.weakest).normalized();
  return margin;
}

}  // namespace morphe::closure
