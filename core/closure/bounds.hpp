#pragma once

#include <algorithm>
#include <cmath>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// Bounds lower <= value <= upper, and the twist u whose h(u) (wrench_set.hpp) gives `upper`.
struct Bounds {
  double lower = -kInfinity, upper = kInfinity;
  Wrench direction = Wrench::Zero();

  /// Replaces the upper bound if the value is smaller.
  void update_upper(double value, const Wrench& u) {
    if (value < upper) {
      upper = value;
      direction = u;
    }
  }
};

/// The required accuracy of bounds: upper - lower is at most `absolute` or, for bounds of one sign,
/// `relative` times the smaller magnitude. Searches end after `max_insertions` anyway.
struct BoundTolerance {
  double relative = 0.05, absolute = 1e-3;
  int max_insertions = 400;
};

/// Returns true if the bounds have the required accuracy.
inline bool is_within_tolerance(const Bounds& bounds, const BoundTolerance& tolerance) {
  const double gap = bounds.upper - bounds.lower;
  const bool same_sign = bounds.lower > 0 || bounds.upper < 0;
  const double min_magnitude = std::min(std::abs(bounds.lower), std::abs(bounds.upper));
  return gap <= tolerance.absolute || (same_sign && gap <= tolerance.relative * min_magnitude);
}

}  // namespace morphe::closure
