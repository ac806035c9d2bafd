#pragma once

namespace morphe::synthesize {

enum class ProfileShape { minimum_jerk, lognormal, beta };

/// Which share of a way is covered when. Velocity and acceleration begin and end at zero.
///   minimum_jerk: s(τ) = 10 τ³ - 15 τ⁴ + 6 τ⁵ over the duration
///   lognormal:    s(t) = Φ((ln t - μ) / σ), parameter = σ; the duration is that of the speed above
///                 5 % of its peak. Before it lies a short head, behind it a long tail, cut where
///                 1 - s < 3e-7
///   beta:         s'(τ) ∝ τ³ (1 - τ)^m, peak at τ = parameter = 3 / (3 + m)
struct Profile {
  ProfileShape shape = ProfileShape::minimum_jerk;
  double begin_s = 0, duration_s = 1;
  double parameter = 0;
};

/// 0 before, 1 afterwards.
double covered_share(const Profile& profile, double time_s);

}  // namespace morphe::synthesize
