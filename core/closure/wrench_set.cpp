#include "core/closure/wrench_set.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::closure {
namespace {

/// Of one contact's cone at normal force 1. The tangential force is put together from two unit
/// vectors: b itself is nothing but rounding where v lies along the normal.
Support cone_support(const WrenchSet& set, const WrenchSet::Cone& cone, const Wrench& u) {
  const Vec3 turn = u.tail<3>(), velocity = u.head<3>() + turn.cross(cone.lever);
  const double across = cone.across.dot(velocity), along = cone.along.dot(velocity);
  const double spin = cone.normal.dot(turn), mu2 = set.mu * set.mu, g2 = set.g * set.g;
  const double grip = std::sqrt(mu2 * (across * across + along * along) + g2 * spin * spin);
  Vec3 force = cone.normal;
  double moment = 0;
  if (grip > 0) {
    force += mu2 / grip * (across * cone.across + along * cone.along);
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
  set.g = contacts.friction.gamma_m / contacts.torque_scale_m;
  for (const Contact& contact : contacts.contacts) {
    WrenchSet::Cone cone;
    cone.lever = lever(contacts, contact);
    cone.normal = contact.normal.normalized();
    cone.across = cone.normal.unitOrthogonal();
    cone.along = cone.normal.cross(cone.across);
    const double reach =
        std::sqrt((1 + set.mu * set.mu) * (1 + cone.lever.squaredNorm()) + set.g * set.g);
    if (limit == ForceLimit::each) cone.most = contact.share;
    set.radius =
        limit == ForceLimit::sum ? std::max(set.radius, reach) : set.radius + cone.most * reach;
    set.cones.push_back(cone);
  }
  set.rounding = kRounding * set.radius;
  return set;
}

Support support(const WrenchSet& set, const Wrench& u) {
  Support all;
  bool first = true;
  for (const WrenchSet::Cone& cone : set.cones) {
    const Support one = cone_support(set, cone, u);
    if (set.limit == ForceLimit::each) {
      if (one.value > 0) {
        all.value += cone.most * one.value;
        all.point += cone.most * one.point;
      }
    } else if (first || one.value > all.value) {
      all = one;
    }
    first = false;
  }
  return all;
}

}  // namespace morphe::closure
