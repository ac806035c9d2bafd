#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"

namespace morphe::segment {

/// A hand that goes from point to point along straight minimum-jerk strokes; 100 Hz.
struct SyntheticHand {
  struct Stroke {
    double begin_s, length_s;
    Vec3 by;
  };
  Vec3 start{0.2, 0.1, 0.02};
  double length_s = 5;
  std::vector<Stroke> strokes;  ///< may overlap: they add up
  std::vector<Stroke> finger;   ///< likewise, of the index tip alone
  /// Thumb–index opening: (time, opening) knots, cosine between them.
  std::vector<std::pair<double, double>> opening{{0, 0.09}};
  double noise_m = 0;

  static double progress(double tau) {
    tau = std::clamp(tau, 0.0, 1.0);
    return tau * tau * tau * (10 + tau * (-15 + 6 * tau));
  }
  double opening_at(double t) const {
    for (std::size_t i = 1; i < opening.size(); ++i) {
      const auto& [t0, a0] = opening[i - 1];
      const auto& [t1, a1] = opening[i];
      if (t <= t1) return a0 + (a1 - a0) * progress((t - t0) / (t1 - t0));
    }
    return opening.back().second;
  }
  HumanMotion motion() const {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 1);
    const auto frames = static_cast<std::size_t>(std::lround(length_s * 100)) + 1;
    HumanMotion m;
    m.tip = Array2D<Vec3>(frames, kFingerCount, unknown_point());
    for (std::size_t i = 0; i < frames; ++i) {
      const double t = 0.01 * static_cast<double>(i);
      Vec3 index = start;
      for (const Stroke& s : strokes) index += progress((t - s.begin_s) / s.length_s) * s.by;
      const Vec3 knuckle = index;
      for (const Stroke& s : finger) index += progress((t - s.begin_s) / s.length_s) * s.by;
      const auto jitter = [&]() -> Vec3 {
        return Vec3(noise(random), noise(random), noise(random)) * noise_m;
      };
      m.time.push_back(t);
      m.tip(i, 1) = index + jitter();
      m.tip(i, 0) = index - opening_at(t) * Vec3::UnitX() + jitter();
      m.wrist.push_back(knuckle + Vec3(0, -0.16, 0.03) + jitter());
    }
    return m;
  }
};

/// Reach 0.8–1.6, grasp, lift 1.9–2.8, pause, home 3.2–4.0, with the hand opening for an object.
inline SyntheticHand drinking_hand() {
  SyntheticHand hand;
  const Vec3 reach(0.06, 0.25, 0.06), lift(-0.1, -0.25, 0.4);
  hand.strokes = {{0.8, 0.8, reach}, {1.9, 0.9, lift}, {3.2, 0.8, -reach - lift}};
  hand.opening = {{0, 0.09}, {0.85, 0.09}, {1.3, 0.13}, {1.7, 0.11}, {3.2, 0.11}, {4.0, 0.09}};
  return hand;
}

/// Returns the kinds of the main phases.
inline std::vector<PhaseKind> kinds(const Movement& movement) {
  std::vector<PhaseKind> result;
  for (const Phase& phase : movement.phases)
    if (main_phase_of(phase.kind) == phase.kind) result.push_back(phase.kind);
  return result;
}

}  // namespace morphe::segment
