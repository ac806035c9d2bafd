#include "core/closure/wrench_set.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::closure {
namespace {

/// Computes the support of one contact's cone at normal force 1. The tangential force is composed
/// of two unit vectors, because b itself consists of rounding only if v is along the normal.
Support cone_support(const WrenchSet& set, const WrenchSet::Cone& cone, const Wrench& u) {
  const Vec3 turn = u.tail<3>(), velocity = u.head<3>() + turn.cross(cone.lever);
  const double across = cone.tangent_a.dot(velocity), along = cone.tangent_b.dot(velocity);
  const double spin = cone.normal.dot(turn), mu2 = set.mu * set.mu, g2 = set.gamma * set.gamma;
  const double grip = std::sqrt(mu2 * (across * across + along * along) + g2 * spin * spin);
  Vec3 force = cone.normal;
  double moment = 0;
  if (grip > 0) {
    force += mu2 / grip * (across * cone.tangent_a + along * cone.tangent_b);
    moment = g2 * spin / grip;
  }
  Support found{cone.normal.dot(velocity) + grip, wrench_of(force, cone.lever)};
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
    cone.lever = moment_arm(contacts, contact);
    cone.normal = contact.normal.normalized();
    cone.tangent_a = cone.normal.unitOrthogonal();
    cone.tangent_b = cone.normal.cross(cone.tangent_a);
    const double reach =
        std::sqrt((1 + set.mu * set.mu) * (1 + cone.lever.squaredNorm()) + set.gamma * set.gamma);
    if (limit == ForceLimit::each) cone.max_normal_force = contact.force_limit_share;
    set.radius = limit == ForceLimit::sum ? std::max(set.radius, reach)
                                          : set.radius + cone.max_normal_force * reach;
    set.cones.push_back(cone);
  }
  set.rounding = kRelativeRounding * set.radius;
  return set;
}

Support support(const WrenchSet& set, const Wrench& u) {
  Support all;
  bool first = true;
  for (const WrenchSet::Cone& cone : set.cones) {
    const Support one = cone_support(set, cone, u);
    if (set.limit == ForceLimit::each) {
      if (one.value > 0) {
        all.value += cone.max_normal_force * one.value;
        all.point += cone.max_normal_force * one.point;
      }
    } else if (first || one.value > all.value) {
      all = one;
    }
    first = false;
  }
  return all;
}

}  // namespace morphe::closure
