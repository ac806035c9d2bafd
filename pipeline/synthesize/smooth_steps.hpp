#pragma once

#include <Eigen/Core>
#include <vector>

#include "pipeline/synthesize/speed_profile.hpp"

namespace morphe::synthesize {

/// A quantity that moves in steps k, which may overlap, with path shares s_k from 0 to 1:
///   q(t) = start + Σ_k (delta_k s_k(t) + detour_k b(s_k(t))),  b(s) = 64 s³ (1 - s)³,  b(½) = 1
/// It is twice continuously differentiable if the s_k are.
template <int N>
struct SmoothSteps {
  using Value = Eigen::Matrix<double, N, 1>;
  /// A step of the quantity.
  struct Step {
    SpeedProfile profile;  ///< s_k
    Value delta = Value::Zero();
    Value detour = Value::Zero();  ///< displacement halfway, in addition to half of delta
  };
  Value start = Value::Zero();  ///< before the first step
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
      const double bump = 4 * s * (1 - s);
      value += s * step.delta + bump * bump * bump * step.detour;
    }
    return value;
  }
};

}  // namespace morphe::synthesize
