#include "core/closure/wrench_set.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::closure {
namespace {

/// Computes the support of one contact's cone at normal force 1. The tangential force is composed
/// of two unit vectors, because b itself consists of rounding only if v is along the normal.
Support cone_support(const WrenchSet& set, const WrenchSet::Cone& cone, const Wrench& u) {
  const Vec3 rotation = u.tail<3>(), velocity = u.head<3>() + rotation.cross(cone.scaled_arm);
  const double slip_a = cone.tangent_a.dot(velocity), slip_b = cone.tangent_b.dot(velocity);
  const double spin = cone.normal.dot(rotation), mu2 = set.mu * set.mu, g2 = set.gamma * set.gamma;
  const double s = std::sqrt(mu2 * (slip_a * slip_a + slip_b * slip_b) + g2 * spin * spin);
  Vec3 force = cone.normal;
  double moment = 0;
  if (s > 0) {
    force += mu2 / s * (slip_a * cone.tangent_a + slip_b * cone.tangent_b);
    moment = g2 * spin / s;
  }
  Support found{cone.normal.dot(velocity) + s, wrench_of(force, cone.scaled_arm)};
  found.point.tail<3>() += moment * cone.normal;
  return found;
}

}  // namespace

WrenchSet make_wrench_set(const ContactSet& contacts, ForceLimit limit) {
  WrenchSet set;
  set.limit = limit;
  set.mu = contacts.friction.mu;
  set.gamma = contacts.friction.gamma_m / contacts.torque_scale_m;
  for (const Contact& contact : contacts.contacts) {
    WrenchSet::Cone cone;
    cone.scaled_arm = moment_arm(contacts, contact);
    cone.normal = contact.normal.normalized();
    cone.tangent_a = cone.normal.unitOrthogonal();
    cone.tangent_b = cone.normal.cross(cone.tangent_a);
    const double norm_bound = std::sqrt(
        (1 + set.mu * set.mu) * (1 + cone.scaled_arm.squaredNorm()) + set.gamma * set.gamma);
    if (limit == ForceLimit::each) cone.max_normal_force = contact.force_limit_share;
    set.radius = limit == ForceLimit::sum ? std::max(set.radius, norm_bound)
                                          : set.radius + cone.max_normal_force * norm_bound;
    set.cones.push_back(cone);
  }
  set.rounding = kRelativeRounding * set.radius;
  return set;
}

Support support(const WrenchSet& set, const Wrench& u) {
  Support total;
  bool first = true;
  for (const WrenchSet::Cone& cone : set.cones) {
    const Support contribution = cone_support(set, cone, u);
    if (set.limit == ForceLimit::each) {
      if (contribution.value > 0) {
        total.value += cone.max_normal_force * contribution.value;
        total.point += cone.max_normal_force * contribution.point;
      }
    } else if (first || contribution.value > total.value) {
      total = contribution;
    }
    first = false;
  }
  return total;
}

}  // namespace morphe::closure
