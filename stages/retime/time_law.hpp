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

/// Computes the fastest law within the path's limits: by reachability analysis for velocity and
/// acceleration and, if a joint's jerk is bounded, by optimising the squared velocity within that
/// bound, too. grid_steps and knots are the numbers for the two; fewer are coarser and faster.
TimeLaw fastest_law(const ConstrainedPath& paced_path, Eigen::Index grid_steps, Eigen::Index knots);
/// Computes the fastest law with as many steps as the path's spline needs.
TimeLaw fastest_law(const ConstrainedPath& paced_path);

/// A law and the number of controller periods to which sample_law() stretches it.
struct QuantizedLaw {
  TimeLaw law;
  Eigen::Index periods = 0;
  Eigen::Index rest = 0;  ///< additional periods, at rest at the end
};
constexpr double kMaxPeriodCount = 1e12;  ///< larger numbers are clamped to this
/// Returns the least number of periods for the samples of a law.
Eigen::Index min_periods(const TimeLaw& law, double rate_hz);

/// Computes the fastest law that the limits allow.
QuantizedLaw fastest_mode_law(ConstrainedPath& paced_path, double rate_hz);
/// Computes a law with du/dt <= 1. A delay of up to 5 % (starting and stopping may take time that
/// the demonstration did not take) is recovered near both ends, at up to 1.4 times the
/// demonstration's speed, if the limits allow it.
QuantizedLaw human_mode_law(ConstrainedPath& paced_path, double rate_hz);
/// Computes a law with du/dt <= 1 while it is on time; delays caused by the limits are recovered
/// afterwards with up to 1.4, until it is on time again.
QuantizedLaw catch_up_mode_law(ConstrainedPath& paced_path, double rate_hz);
/// Computes a law that takes a given number of periods, in the human's proportions at a constant
/// factor, as far as possible; nullopt if even the fastest law takes longer. For a path that has
/// already been processed by this function and slowed down since, the search starts from its last
/// nominal path velocity.
std::optional<QuantizedLaw> duration_mode_law(ConstrainedPath& paced_path, double rate_hz,
                                              Eigen::Index periods);

/// The samples of a law. c_k = u at the sample instants, stretched to `periods` - 2 and with a
/// period of rest at each end, are the coefficients of a cubic B-spline in time with its knots at
/// the instants; `rest` further samples follow at the end. The spline averages the law over
/// neighbouring periods: velocity, acceleration and jerk do not increase, acceleration is
/// continuous and linear between the instants, and both ends are at rest. The quintics between
/// samples of q(u(t)) then follow it closely, because no switching point lies between them.
struct SampledLaw {
  Trajectory trajectory;
  std::vector<double> clock;  ///< u at the samples
};
/// Samples a law at the controller's rate.
SampledLaw sample_law(const ConstrainedPath& paced_path, const QuantizedLaw& paced, double rate_hz);

}  // namespace morphe::retime
