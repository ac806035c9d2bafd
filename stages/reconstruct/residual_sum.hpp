#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// The root mean square and the greatest absolute value of the finite numbers that were added.
class ResidualSum {
 public:
  /// Adds a number.
  void add(double value) {
    if (!std::isfinite(value)) return;
    squares_ += value * value;
    max_ = std::max(max_, std::abs(value));
    ++count_;
  }
  /// Returns the root mean square; NaN if there are no numbers.
  double rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : kUnknown; }
  /// Returns the residual of that name; NaN if there are no numbers.
  Residual residual(const std::string& name) const {
    return {name, rms(), count_ > 0 ? max_ : kUnknown};
  }
  /// Adds the residual of that name to a list if there are numbers.
  void report(const std::string& name, std::vector<Residual>& residuals) const {
    if (count_ > 0) residuals.push_back(residual(name));
  }

 private:
  double squares_ = 0, max_ = 0, count_ = 0;
};

}  // namespace morphe::reconstruct
