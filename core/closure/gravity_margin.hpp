#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

inline constexpr double kGravity = 9.81;  ///< [m/s^2]

/// What is held, in the object's frame.
struct Load {
  double mass_kg = 0;
  Vec3 centre = Vec3::Zero();  ///< of mass [m]
};

/// How much of a weight a grasp bears, each contact pressing with at most 1 N: lambda is the
/// largest number for which forces inside the cones balance a weight of lambda newtons. The squeeze
/// that a mass needs is N = 9.81 M / lambda newtons per contact, if forces are shared as well as
/// they can be: necessary, not sufficient.
struct GravityMargin {
  double lower = 0, upper = 0;      ///< of lambda
  Vec3 direction = Vec3::Zero();    ///< unit, of gravity; of the worst margin the one that is worst
  Wrench weakest = Wrench::Zero();  ///< unit twist: upper = h / (what gravity does in it)
  bool within_tolerance = false;
  int insertions = 0, facets = 0;

  /// Enough for sure, and not enough for sure [N]; infinite where no squeeze is known to hold it,
  /// or none can.
  double newtons_enough(double mass_kg) const;
  double newtons_too_few(double mass_kg) const;
};

/// In a direction of gravity, which need not be a unit vector:
/// lambda(d) = min over u with u·w_d < 0 of h(u) / -(u·w_d), w_d = (d, (com - c) × d / rho).
GravityMargin gravity_margin(const ContactSet& contacts, const Load& load, const Vec3& gravity,
                             const Tolerance& tolerance = {0.01, 1e-3, 400});

/// In the worst direction: min over u of h(u) / |u_f + u_t × (com - c) / rho|, which is how fast
/// the centre of mass moves under the twist.
GravityMargin worst_gravity_margin(const ContactSet& contacts, const Load& load,
                                   const Tolerance& tolerance = {0.01, 1e-3, 400});

}  // namespace morphe::closure
