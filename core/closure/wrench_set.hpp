#pragma once

#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// Points of a set and their distances are known to this share of its radius.
inline constexpr double kRounding = 1e-12;

/// What bounds the normal forces that make up a set of wrenches.
enum class ForceLimit {
  sum,  ///< they sum to 1 (L1): the hull of the contacts' cones at normal force 1
  /// Each is from 0 to its contact's share, 1 by default (L∞): the sum of the contacts' cones, each
  /// cut off there; holds 0.
  each,
};

/// The wrenches that contacts can bring about together.
struct WrenchSet {
  struct Cone {
    Vec3 lever, normal, across, along;  ///< the last two span the tangent plane
    double most = 1;                    ///< normal force
  };
  ForceLimit limit = ForceLimit::sum;
  double mu = 0, g = 0;  ///< g = gamma / rho
  std::vector<Cone> cones;
  double radius = 0;    ///< |w| <= radius, so |h(u) - h(v)| <= radius |u - v|
  double rounding = 0;  ///< kRounding * radius

  /// How well h(u) is known.
  double evaluation() const { return 0.01 * rounding; }
};

WrenchSet make_wrench_set(const ContactSet& contacts, ForceLimit limit);

/// A point of the set that lies farthest in a direction u, and h(u) = max u·w over the set.
struct Support {
  double value = 0;
  Wrench point = Wrench::Zero();
};

/// h_i = n·v + s with v = u_f + u_t × r (the contact point's velocity under the twist u),
/// b = v - (n·v) n, t = n·u_t, s = sqrt(mu^2 |b|^2 + g^2 t^2); attained by the force n + mu^2 b / s
/// with the moment rho g^2 t / s. L1: max h_i, below 0 where all contacts push away from u; L∞: sum
/// of share_i max(0, h_i). Without contacts both sets are {0}.
Support support(const WrenchSet& set, const Wrench& u);

}  // namespace morphe::closure
