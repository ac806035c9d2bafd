#include "stages/map/phase_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::map {
namespace {

humanlike::FrameWeights weights_of_phase(const std::vector<PhaseWeights>& weights,
                                         PhaseKind phase) {
  for (const PhaseWeights& w : weights) {
    if (w.phase == phase) return w.factors;
  }
  return {};
}

}  // namespace

std::string validation_error(const std::vector<PhaseWeights>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const PhaseWeights& w = weights[i];
    for (std::size_t k = 0; k < i; ++k) {
      if (weights[k].phase == w.phase)
        return fmt::format("phase {} appears twice", name_of(w.phase));
    }
    const humanlike::FrameWeights& s = w.factors;
    if (std::min({s.tip_position, s.tip_orientation, s.humanlike_arm, s.humanlike_fingers}) < 0) {
      return "weights must not be negative";
    }
  }
  return "";
}

humanlike::FrameWeights weights_at(const std::vector<PhaseWeights>& weights,
                                   const std::vector<Phase>& phases, double time_s,
                                   double blend_s) {
  if (weights.empty()) return {};
  const auto at = [&](double t) { return weights_of_phase(weights, phase_at(phases, t)); };
  if (blend_s <= 0) return at(time_s);
  // The window from -1 to 1 is cut at the boundaries of phases.
  std::vector<double> cuts{-1, 1};
  for (const Phase& phase : phases) {
    for (const double boundary : {phase.begin_s, phase.end_s}) {
      cuts.push_back(std::clamp(2 * (boundary - time_s) / blend_s, -1.0, 1.0));
    }
  }
  std::ranges::sort(cuts);
  const auto filled = [](double place) {  // integral of (1 + cos(pi place)) / 2
    return 0.5 * (1 + place) + std::sin(std::numbers::pi * place) / (2 * std::numbers::pi);
  };
  humanlike::FrameWeights sum{0, 0, 0, 0};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double share = filled(cuts[i]) - filled(cuts[i - 1]);
    if (share <= 0) continue;
    const humanlike::FrameWeights own = at(time_s + 0.25 * blend_s * (cuts[i - 1] + cuts[i]));
    sum.tip_position += share * own.tip_position;
    sum.tip_orientation += share * own.tip_orientation;
    sum.humanlike_arm += share * own.humanlike_arm;
    sum.humanlike_fingers += share * own.humanlike_fingers;
  }
  return sum;
}

}  // namespace morphe::map
