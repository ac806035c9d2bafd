#include "core/closure/general_position.hpp"

#include <algorithm>

namespace morphe::closure {
namespace {

/// Takes out of v what lies along orthonormal directions; twice, against rounding.
Wrench off(const std::vector<Wrench>& directions, Wrench v) {
  for (int pass = 0; pass < 2; ++pass) {
    for (const Wrench& direction : directions) v -= direction.dot(v) * direction;
  }
  return v;
}

/// The coordinate axis that is farthest off the directions, without what lies along them.
Wrench farthest_off(const std::vector<Wrench>& directions) {
  Wrench farthest = Wrench::Zero();
  for (int axis = 0; axis < 6; ++axis) {
    const Wrench rest = off(directions, Wrench::Unit(axis));
    if (rest.squaredNorm() > farthest.squaredNorm() * (1 + 1e-9)) farthest = rest;
  }
  return farthest.normalized();
}

}  // namespace

GeneralPosition general_position(const WrenchSet& set) {
  const double none = 16 * set.rounding;
  GeneralPosition found;
  std::vector<Wrench> taken;
  while (taken.size() < 6) {
    const Wrench u = farthest_off(taken);
    const Support up = support(set, u), down = support(set, -u);
    found.asked.insert(found.asked.end(), {u, -u});
    found.heights.insert(found.heights.end(), {up.value, down.value});
    if (found.corners.empty()) {
      found.corners.push_back(set.limit == ForceLimit::each ? Wrench::Zero() : down.point);
    }
    const Wrench first = found.corners.front();
    const double upwards = up.value - u.dot(first), downwards = down.value + u.dot(first);
    if (std::max(upwards, downwards) <= none) {
      found.flat.push_back(u);
      taken.push_back(u);
      continue;
    }
    const Wrench& point = upwards >= downwards ? up.point : down.point;
    found.corners.push_back(point);
    taken.push_back(off(taken, point - first).normalized());
  }
  return found;
}

}  // namespace morphe::closure
