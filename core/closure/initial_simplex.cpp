#include "core/closure/initial_simplex.hpp"

#include <algorithm>

namespace morphe::closure {
namespace {

/// Removes from v its components along orthonormal directions; done twice to reduce rounding.
Wrench project_out(const std::vector<Wrench>& directions, Wrench v) {
  for (int pass = 0; pass < 2; ++pass)
    for (const Wrench& direction : directions) v -= direction.dot(v) * direction;
  return v;
}

/// Returns the unit vector perpendicular to the directions and nearest to any coordinate axis.
Wrench least_covered_axis(const std::vector<Wrench>& directions) {
  Wrench farthest = Wrench::Zero();
  for (int axis = 0; axis < 6; ++axis) {
    const Wrench rest = project_out(directions, Wrench::Unit(axis));
    if (rest.squaredNorm() > farthest.squaredNorm() * (1 + 1e-9)) farthest = rest;
  }
  return farthest.normalized();
}

}  // namespace

InitialSimplex initial_simplex(const WrenchSet& set) {
  const double flat_extent = 16 * set.rounding;
  InitialSimplex found;
  std::vector<Wrench> spanned;
  while (spanned.size() < 6) {
    const Wrench u = least_covered_axis(spanned);
    const Support up = support(set, u), down = support(set, -u);
    found.queried_directions.insert(found.queried_directions.end(), {u, -u});
    found.support_values.insert(found.support_values.end(), {up.value, down.value});
    if (found.vertices.empty())
      found.vertices.push_back(set.limit == ForceLimit::each ? Wrench::Zero() : down.point);
    const Wrench first = found.vertices.front();
    const double upwards = up.value - u.dot(first), downwards = down.value + u.dot(first);
    if (std::max(upwards, downwards) <= flat_extent) {
      found.flat_directions.push_back(u);
      spanned.push_back(u);
      continue;
    }
    const Wrench& point = upwards >= downwards ? up.point : down.point;
    found.vertices.push_back(point);
    spanned.push_back(project_out(spanned, point - first).normalized());
  }
  return found;
}

}  // namespace morphe::closure
