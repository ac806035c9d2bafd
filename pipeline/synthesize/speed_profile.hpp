#pragma once

namespace morphe::synthesize {

/// The shapes of speed profiles.
enum class SpeedProfileShape { minimum_jerk, lognormal, beta };

/// The share s of a path over time, with τ = (t - begin_s) / duration_s. Velocity and acceleration
/// begin and end at zero, for a lognormal up to the cut.
///   minimum_jerk: s(τ) = 10 τ³ - 15 τ⁴ + 6 τ⁵
///   lognormal:    s(t) = Φ((ln (t - t₀) - μ) / σ), parameter = σ. The speed is above 5 % of its
///   peak
///                 from begin_s for duration_s. There is a short head before and a long tail after
///                 this interval; they are cut at s < 3e-7 and 1 - s < 3e-7
///   beta:         s'(τ) ∝ τ³ (1 - τ)^m, parameter = 3 / (3 + m), the τ of the peak
struct SpeedProfile {
  SpeedProfileShape shape = SpeedProfileShape::minimum_jerk;
  double begin_s = 0, duration_s = 1;
  double parameter = 0;  ///< σ, or τ of the peak; unused by minimum_jerk
};

/// Returns the share of the path at a time, 0 before and 1 after the profile.
double path_share(const SpeedProfile& profile, double time_s);

}  // namespace morphe::synthesize
