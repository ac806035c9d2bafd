#pragma once

#include <vector>

#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// n + 1 points of a set of wrenches that span all of its n <= 6 dimensions.
struct InitialSimplex {
  std::vector<Wrench> vertices;            ///< for L∞ the first is 0
  std::vector<Wrench> queried_directions;  ///< unit directions for which the support was computed
  std::vector<double> support_values;      ///< h(u) of these directions
  /// 6 - n orthonormal directions in which the set is flat: no wider than 16 times its rounding.
  std::vector<Wrench> flat_directions;
};

/// Finds an initial simplex of a set.
InitialSimplex initial_simplex(const WrenchSet& set);

}  // namespace morphe::closure
