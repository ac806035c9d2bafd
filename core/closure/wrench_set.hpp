#pragma once

#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// Relative rounding, with respect to the radius of a set, of its points and their distances.
inline constexpr double kRelativeRounding = 1e-12;

/// The constraint on the normal forces that form a set of wrenches.
enum class ForceLimit {
  sum,  ///< they sum to 1 (L1): the convex hull of the contacts' cones at normal force 1
  /// Each is between 0 and its contact's force_limit_share (L∞): the Minkowski sum of the contacts'
  /// cones, each truncated at this force; contains 0.
  each,
};

/// The set of wrenches that contacts can exert together.
struct WrenchSet {
  /// The friction cone of a contact.
  struct Cone {
    Vec3 scaled_arm, normal, tangent_a, tangent_b;  ///< the tangents span the tangent plane
    double max_normal_force = 1;
  };
  ForceLimit limit = ForceLimit::sum;
  double mu = 0, gamma = 0;  ///< gamma divided by rho, g below
  std::vector<Cone> cones;
  double radius = 0;    ///< |w| <= radius, so |h(u) - h(v)| <= radius |u - v|
  double rounding = 0;  ///< kRelativeRounding * radius

  /// Returns the error bound of h(u).
  double support_error() const { return 0.01 * rounding; }
};

/// Computes the wrench set of valid contacts.
WrenchSet make_wrench_set(const ContactSet& contacts, ForceLimit limit);

/// A point of the set that is extreme in a direction u, and h(u) = max u·w over the set.
struct Support {
  double value = 0;
  Wrench point = Wrench::Zero();
};

/// Computes the support function h and a point that attains it. With the velocity v = u_f + u_t × r
/// of a contact point under the twist u, b = v - (n·v) n, t = n·u_t and s = sqrt(mu^2 |b|^2 + g^2
/// t^2), contact i has h_i = n·v + s, by the force n + mu^2 b / s and the moment rho g^2 t / s. L1:
/// h = max h_i, negative if all contacts push away from u. L∞: h = sum of share_i max(0, h_i).
/// Without contacts both sets are {0}.
Support support(const WrenchSet& set, const Wrench& u);

}  // namespace morphe::closure
