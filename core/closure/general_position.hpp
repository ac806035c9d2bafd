#pragma once

#include <vector>

#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// n + 1 points of a set of wrenches that span all of its n <= 6 dimensions.
struct GeneralPosition {
  std::vector<Wrench> corners;  ///< of L∞ the first is 0
  std::vector<Wrench> asked;    ///< unit directions whose support was sought on the way
  std::vector<double> heights;  ///< and their h(u)
  /// Orthonormal, 6 - n of them: along each the set is no wider than 16 roundings, which proves
  /// that it is flat.
  std::vector<Wrench> flat;
};

GeneralPosition general_position(const WrenchSet& set);

}  // namespace morphe::closure
