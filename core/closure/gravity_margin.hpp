#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// The mass of the grasped object and its centre, in the object's frame.
struct Load {
  double mass_kg = 0;
  Vec3 centre_of_mass = Vec3::Zero();  ///< position [m]
};

/// The weight that a grasp can support if each contact presses with at most 1 N: lambda is the
/// largest number for which forces inside the cones balance a weight of lambda newtons. A mass M
/// needs a squeeze of 9.81 M / lambda newtons per contact: enough only if forces are optimal.
struct GravityMargin {
  double lower = 0, upper = 0;      ///< of lambda
  Vec3 direction = Vec3::Zero();    ///< unit direction of gravity: the given or the worst one
  Wrench weakest = Wrench::Zero();  ///< unit twist: upper = h / (power of gravity in it)
  bool within_tolerance = false;
  int insertions = 0, facets = 0;

  /// Returns a certainly sufficient force [N], infinite if no squeeze is known to hold the mass.
  double sufficient_force_n(double mass_kg) const;
};

/// Computes the margin for one direction of gravity, which need not be a unit vector:
/// lambda(d) = min over u with u·w_d < 0 of h(u) / -(u·w_d), w_d = (d, (com - c) × d / rho).
GravityMargin gravity_margin(const ContactSet& contacts, const Load& load, const Vec3& gravity,
                             const BoundTolerance& tolerance = {0.01, 1e-3, 400});

/// Computes the margin for the worst direction: min over u of h(u) / |u_f + u_t × (com - c) / rho|,
/// in which the denominator is the speed of the centre of mass under the twist.
GravityMargin worst_gravity_margin(const ContactSet& contacts, const Load& load,
                                   const BoundTolerance& tolerance = {0.01, 1e-3, 400});

}  // namespace morphe::closure
