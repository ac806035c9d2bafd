#pragma once

#include <algorithm>
#include <cmath>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// lower <= value <= upper, and the twist u whose h(u) is the upper bound.
struct Bounds {
  double lower = -kInfinity, upper = kInfinity;
  Wrench direction = Wrench::Zero();

  void ask(double value, const Wrench& u) {
    if (value < upper) {
      upper = value;
      direction = u;
    }
  }
};

/// When bounds are near enough: upper - lower is at most `absolute`, or at most `relative` times
/// the smaller of their magnitudes. Searches that reach `most_insertions` end with the bounds so
/// far.
struct Tolerance {
  double relative = 0.05;
  double absolute = 1e-3;
  int most_insertions = 400;
};

inline bool near_enough(const Bounds& bounds, const Tolerance& tolerance) {
  const double gap = bounds.upper - bounds.lower;
  const bool same_sign = bounds.lower > 0 || bounds.upper < 0;
  const double least = std::min(std::abs(bounds.lower), std::abs(bounds.upper));
  return gap <= tolerance.absolute || (same_sign && gap <= tolerance.relative * least);
}

}  // namespace morphe::closure
