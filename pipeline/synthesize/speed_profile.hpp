#pragma once

namespace morphe::synthesize {

/// The shapes of speed profiles.
enum class SpeedProfileShape { minimum_jerk, lognormal, beta };

/// The share of a path that is covered as a function of time. Velocity and acceleration begin and
/// end at zero.
///   minimum_jerk: s(τ) = 10 τ³ - 15 τ⁴ + 6 τ⁵ over the duration
///   lognormal:    s(t) = Φ((ln t - μ) / σ), parameter = σ; the duration is that of the speed above
///                 5 % of its peak. It is preceded by a short head and followed by a long tail, cut
///                 at 1 - s < 3e-7
///   beta:         s'(τ) ∝ τ³ (1 - τ)^m, peak at τ = parameter = 3 / (3 + m)
struct SpeedProfile {
  /// The shape of the profile.
  SpeedProfileShape shape = SpeedProfileShape::minimum_jerk;
  /// The begin and the duration [s].
  double begin_s = 0, duration_s = 1;
  /// The parameter of the shape.
  double parameter = 0;
};

/// Returns the share at a time, 0 before and 1 after the profile.
double path_share(const SpeedProfile& profile, double time_s);

}  // namespace morphe::synthesize
