#include "core/closure/opposed_contacts.hpp"

#include <cmath>

namespace morphe::closure {

bool are_opposed(const Contact& a, const Contact& b, double friction_coefficient) {
  const Vec3 between = b.point - a.point;
  const double min_along = between.norm() / std::hypot(1, friction_coefficient);
  return min_along > 0 && a.normal.dot(between) >= min_along && -b.normal.dot(between) >= min_along;
}

bool has_opposed_contacts(const ContactSet& set) {
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    for (std::size_t j = i + 1; j < set.contacts.size(); ++j) {
      if (are_opposed(set.contacts[i], set.contacts[j], set.friction.mu)) return true;
    }
  }
  return false;
}

}  // namespace morphe::closure
