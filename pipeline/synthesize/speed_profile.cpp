#include "pipeline/synthesize/speed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::synthesize {
namespace {

/// Returns the path share of a lognormal profile. With y = ln(t - t₀) - μ, the speed over its peak
/// is exp(-(y + σ²)² / (2 σ²)), which is 5 % at y + σ² = ± σ sqrt(2 ln 20).
double lognormal(const SpeedProfile& p, double time_s) {
  constexpr double kTailDeviate = 5;  // at which head and tail are cut
  const double sigma = p.parameter;
  const double half_log_width = sigma * std::sqrt(2 * std::log(20.0));
  const double mode_s = p.duration_s / (std::exp(half_log_width) - std::exp(-half_log_width));
  const double since_s = time_s - p.begin_s + mode_s * std::exp(-half_log_width);
  if (since_s <= 0) return 0;
  const double deviate = (std::log(since_s / mode_s) - sigma * sigma) / sigma;
  if (deviate < -kTailDeviate) return 0;
  if (deviate > kTailDeviate) return 1;
  return 0.5 * std::erfc(-deviate / std::numbers::sqrt2);
}

/// Returns ∫ (1 - u)³ u^m du from 0 to u.
double beta_integral(double u, double m) {
  return std::pow(u, m + 1) * (1 / (m + 1) - u * (3 / (m + 2) - u * (3 / (m + 3) - u / (m + 4))));
}

/// Returns the path share of a beta profile with its peak at τ = `peak`.
double beta(double tau, double peak) {
  const double m = 3 * (1 - peak) / peak;
  return 1 - beta_integral(1 - tau, m) / beta_integral(1, m);
}

}  // namespace

double path_share(const SpeedProfile& profile, double time_s) {
  if (profile.shape == SpeedProfileShape::lognormal) return lognormal(profile, time_s);
  const double tau = std::clamp((time_s - profile.begin_s) / profile.duration_s, 0.0, 1.0);
  if (tau <= 0 || tau >= 1) return tau;
  if (profile.shape == SpeedProfileShape::beta) return beta(tau, profile.parameter);
  return tau * tau * tau * (10 + tau * (6 * tau - 15));
}

}  // namespace morphe::synthesize
