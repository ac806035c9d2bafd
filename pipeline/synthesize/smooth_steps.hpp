#pragma once

#include <Eigen/Core>
#include <vector>

#include "pipeline/synthesize/speed_profile.hpp"

namespace morphe::synthesize {

/// A quantity that moves in steps: q(t) = start + Σ_k (delta_k s_k(t) + detour_k b(s_k)), b(s) = 64
/// s³ (1 - s)³, which is 1 halfway. Steps may overlap. The function is twice continuously
/// differentiable.
template <int N>
struct SmoothSteps {
  /// The type of the quantity.
  using Value = Eigen::Matrix<double, N, 1>;
  /// A step of the quantity.
  struct Step {
    /// The progress s_k over time.
    SpeedProfile profile;
    /// The total change.
    Value delta = Value::Zero();
    /// The deviation halfway.
    Value detour = Value::Zero();
  };
  /// The value before the first step.
  Value start = Value::Zero();
  /// The steps.
  std::vector<Step> steps;

  /// Returns the value at a time.
  Value at(double time_s) const {
    Value value = start;
    for (const Step& step : steps) {
      const double s = path_share(step.profile, time_s);
      if (s <= 0) continue;
      if (s >= 1) {
        value += step.delta;
        continue;
      }
      const double aside = 4 * s * (1 - s);
      value += s * step.delta + aside * aside * aside * step.detour;
    }
    return value;
  }
};

}  // namespace morphe::synthesize
