#include "stages/map/phase_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::map {

std::string validation_error(const std::vector<PhaseWeights>& weights) {
  for (int i = 0; i < std::ssize(weights); ++i) {
    const PhaseWeights& w = weights[i];
    for (int k = 0; k < i; ++k) {
      if (weights[k].phase == w.phase)
        return fmt::format("phase {} appears twice", name_of(w.phase));
    }
  }
  return "";
}

humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s,
                                   double blend_s) {
  if (weights.empty()) return {};
  const auto factors_at = [&](double t) {
    auto listed = std::ranges::find(weights, phase_at(phases, t), &PhaseWeights::phase);
    if (listed == weights.end())
      listed = std::ranges::find(weights, main_phase_at(phases, t), &PhaseWeights::phase);
    return listed == weights.end() ? humanlike::FrameWeights{} : listed->factors;
  };
  if (blend_s <= 0) return factors_at(time_s);
  // The window from -1 to 1 is cut at the boundaries of phases.
  std::vector<double> cuts{-1, 1};
  for (const Phase& phase : phases) {
    for (const double boundary : {phase.begin_s, phase.end_s}) {
      cuts.push_back(std::clamp(2 * (boundary - time_s) / blend_s, -1.0, 1.0));
    }
  }
  std::ranges::sort(cuts);
  const auto window_integral = [](double end) {  // of (1 + cos(pi x)) / 2 from -1 to `end`
    return 0.5 * (1 + end) + std::sin(std::numbers::pi * end) / (2 * std::numbers::pi);
  };
  humanlike::FrameWeights sum{0, 0, 0, 0};
  for (int i = 1; i < std::ssize(cuts); ++i) {
    const double share = window_integral(cuts[i]) - window_integral(cuts[i - 1]);
    if (share <= 0) continue;
    const auto factors = factors_at(time_s + 0.25 * blend_s * (cuts[i - 1] + cuts[i]));
    sum.tip_position += share * factors.tip_position;
    sum.tip_orientation += share * factors.tip_orientation;
    sum.humanlike_arm += share * factors.humanlike_arm;
    sum.humanlike_fingers += share * factors.humanlike_fingers;
  }
  return sum;
}

}  // namespace morphe::map
