#pragma once

#include <Eigen/Core>
#include <vector>

#include "pipeline/synthesize/profile.hpp"

namespace morphe::synthesize {

/// A quantity that goes from place to place: q(t) = start + Σ_k (delta_k s_k(t) + detour_k b(s_k)),
/// b(s) = 64 s³ (1 - s)³, which is 1 halfway. Steps may overlap; twice continuously differentiable.
template <int N>
struct SmoothSteps {
  using Value = Eigen::Matrix<double, N, 1>;
  struct Step {
    Profile profile;
    Value delta = Value::Zero();
    Value detour = Value::Zero();
  };
  Value start = Value::Zero();
  std::vector<Step> steps;

  Value at(double time_s) const {
    Value value = start;
    for (const Step& step : steps) {
      const double s = covered_share(step.profile, time_s);
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
