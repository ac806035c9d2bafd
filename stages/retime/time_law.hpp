#pragma once

#include <functional>
#include <optional>

#include "stages/retime/constrained_path.hpp"

namespace morphe::retime {

/// The path parameter as a function of time, from rest to rest.
struct TimeLaw {
  double duration_s = 0;
  std::function<double(double)> clock_at;  ///< u at a time, nondecreasing and clamped to the ends
};

/// Computes the fastest law within the path's limits. Reachability analysis on `grid_steps` gives
/// the law within the limits of velocity and acceleration. If a joint's jerk is bounded, a squared
/// velocity with `knots` is then optimised within all limits. Fewer steps and knots are coarser and
/// take less time.
TimeLaw fastest_law(const ConstrainedPath& path, Eigen::Index grid_steps, Eigen::Index knots);
/// Computes the fastest law with as many steps as the path's spline needs.
TimeLaw fastest_law(const ConstrainedPath& path);

/// A law and the number of controller periods to which sample_law() stretches it.
struct QuantizedLaw {
  TimeLaw law;
  Eigen::Index periods = 0;
  Eigen::Index rest = 0;  ///< additional periods, at rest at the end
};
/// Returns the smallest number of periods to which sample_law() can stretch a law: its duration and
/// a period of rest at each end.
Eigen::Index min_periods(const TimeLaw& law, double rate_hz);

/// Computes the fastest law that the limits allow.
QuantizedLaw fastest_mode_law(ConstrainedPath& path, double rate_hz);
/// Computes a law with du/dt <= 1. If the law is late by at most 5 % of the duration, du/dt near
/// both ends may be up to 1.4 to recover the delay.
QuantizedLaw human_mode_law(ConstrainedPath& path, double rate_hz);
/// Computes a law with du/dt <= 1 while it is on time, and up to 1.4 while it recovers a delay.
QuantizedLaw catch_up_mode_law(ConstrainedPath& path, double rate_hz);
/// Computes a law that takes a given number of periods, in the human's proportions as far as
/// possible; nullopt if even the fastest law takes longer. The search starts from the nominal path
/// velocity that an earlier call has set, because the path was only slowed down since.
std::optional<QuantizedLaw> duration_mode_law(ConstrainedPath& path, double rate_hz,
                                              Eigen::Index periods);

/// The samples of a law. The law is stretched to `periods` - 2, with a period of rest at each end
/// and `rest` further ones at the end. Its values u at the sample instants are the coefficients c_k
/// of a cubic B-spline in time with its knots at the instants. The spline averages the law over
/// neighbouring periods, so that velocity, acceleration and jerk do not increase; acceleration is
/// continuous and linear between the instants, and both ends are at rest. The quintics between
/// samples of q(u(t)) follow it closely, because no switching point lies between them.
struct SampledLaw {
  Trajectory trajectory;
  std::vector<double> clock;  ///< u at the samples
};
/// Samples a law at the controller's rate.
SampledLaw sample_law(const ConstrainedPath& path, const QuantizedLaw& quantized, double rate_hz);

}  // namespace morphe::retime
