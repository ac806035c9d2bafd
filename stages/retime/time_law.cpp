#include "stages/retime/time_law.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/jerk_bound.hpp"

namespace morphe::retime {
namespace {

/// Returns the speedups by which a law recovers its delay: min(kMaxSpeedupShare, delay /
/// kSpeedupTime_s) in each cell. The delay assumes that cells in which limits hold the law below
/// its nominal path velocity keep their velocity, and that the others have 1 + their speedup.
std::vector<double> speedups_of(const ConstrainedPath& path, const TimeLaw& law, double rate_hz) {
  const auto cells = std::ssize(path.slowdown);
  const double cell_s = path.spline.duration_s / static_cast<double>(cells);
  std::vector<double> arrival(cells + 1, law.duration_s);  // at the edges of the cells
  arrival[0] = 0;
  int next = 1;
  double previous_u = 0;
  for (double t = 1 / rate_hz; t < law.duration_s && next < cells; t += 1 / rate_hz) {
    const double u = law.clock_at(t);
    for (; next < cells && u >= next * cell_s; ++next) {
      const double share = (next * cell_s - previous_u) / (u - previous_u);
      arrival[next] = t - (1 - share) / rate_hz;
    }
    previous_u = u;
  }
  std::vector<double> speedup(cells, 0);
  double delay_s = 0;
  for (int k = 0; k < cells; ++k) {
    const double previous = path.speedup.empty() ? 0 : path.speedup[k];
    const double velocity = cell_s / std::max(arrival[k + 1] - arrival[k], 1e-9);
    speedup[k] = std::clamp(delay_s / kSpeedupTime_s, 0.0, kMaxSpeedupShare);
    const bool limited = velocity < kAtVelocityCapRatio * (1 + previous);
    delay_s += cell_s / (limited ? std::min(velocity, 1 + speedup[k]) : 1 + speedup[k]) - cell_s;
  }
  return speedup;
}

}  // namespace

TimeLaw fastest_law(const ConstrainedPath& path, Eigen::Index grid_steps, Eigen::Index knots) {
  const PathGrid grid = path_grid(path, grid_steps);
  GridLaw fastest = grid_law(grid.step, fastest_squared_velocities(grid));
  const double duration_s = fastest.time[grid_steps];
  if (!(path.jerk.minCoeff() < kInfinity))
    return {duration_s, [law = std::move(fastest)](double t) { return clock_at(law, t); }};
  const RampedParameter clock = ramp_ends(path.spline.duration_s, kRamp_s);
  const double max_rate = kMaxRampVelocityRatio * std::sqrt(fastest.square.maxCoeff());
  SplineLaw law =
      spline_law(clock, fastest_squared_velocity(path, clock, knots, max_rate, duration_s));
  const double law_s = law.time.back();
  return {law_s, [law = std::move(law)](double t) { return clock_at(law, t); }};
}

TimeLaw fastest_law(const ConstrainedPath& path) {
  const Eigen::Index knots = path.spline.intervals;
  return fastest_law(path, std::max<Eigen::Index>(kMinGridSteps, kStepsPerKnot * knots),
                     std::max<Eigen::Index>(kMinKnots, knots));
}

Eigen::Index min_periods(const TimeLaw& law, double rate_hz) {
  const double periods = std::min(kMaxPeriodCount, std::ceil(law.duration_s * rate_hz - 1e-9));
  return 2 + std::max<Eigen::Index>(1, static_cast<Eigen::Index>(periods));
}

QuantizedLaw fastest_mode_law(ConstrainedPath& path, double rate_hz) {
  path.nominal_path_velocity = kMaxPathVelocity;
  TimeLaw law = fastest_law(path);
  const Eigen::Index periods = min_periods(law, rate_hz);
  return {std::move(law), periods};
}

QuantizedLaw human_mode_law(ConstrainedPath& path, double rate_hz) {
  const double length_s = path.spline.duration_s;
  const Eigen::Index demonstrated = std::lround(length_s * rate_hz);
  path.nominal_path_velocity = 1;
  path.end_speedup_s = std::min(kSpeedupTime_s, 0.5 * length_s);
  QuantizedLaw first;
  for (path.end_speedup = 0; path.end_speedup < kMaxSpeedupShare;) {
    QuantizedLaw quantized;
    quantized.law = fastest_law(path);
    quantized.periods = min_periods(quantized.law, rate_hz);
    if (quantized.periods <= demonstrated) {
      quantized.periods = demonstrated;
      return quantized;
    }
    const double delay_s = static_cast<double>(quantized.periods - demonstrated) / rate_hz;
    const bool recoverable = demonstrated > 2 && delay_s < kMaxRecoverableDelayShare * length_s;
    if (path.end_speedup == 0) first = std::move(quantized);
    if (!recoverable) break;
    path.end_speedup += delay_s / path.end_speedup_s + kMinEndSpeedupStep;
  }
  return first;
}

QuantizedLaw catch_up_mode_law(ConstrainedPath& path, double rate_hz) {
  const Eigen::Index demonstrated = std::lround(path.spline.duration_s * rate_hz);
  path.nominal_path_velocity = 1;
  path.speedup.clear();
  QuantizedLaw quantized;
  for (int k = 0; k < kSpeedupRounds; ++k) {
    if (k > 0) path.speedup = speedups_of(path, quantized.law, rate_hz);
    quantized.law = fastest_law(path);
  }
  quantized.periods = std::max(min_periods(quantized.law, rate_hz), demonstrated);
  return quantized;
}

std::optional<QuantizedLaw> duration_mode_law(ConstrainedPath& path, double rate_hz,
                                              Eigen::Index periods) {
  if (periods <= 2) return std::nullopt;
  const double steady = path.spline.duration_s * rate_hz / static_cast<double>(periods - 2);
  double& velocity = path.nominal_path_velocity;
  velocity = velocity < kMaxPathVelocity ? std::max(velocity, steady) : steady;
  TimeLaw fastest;
  for (int k = 0; k < kMaxPathVelocityCount; ++k) {
    TimeLaw law = fastest_law(path);
    const Eigen::Index law_periods = min_periods(law, rate_hz);
    if (law_periods <= periods) return QuantizedLaw{std::move(law), periods};
    const double next = velocity * kPathVelocityExcessRatio * static_cast<double>(law_periods) /
                        static_cast<double>(periods);
    if (k == 0) {  // checks if any path velocity is fast enough
      velocity = kMaxPathVelocity;
      fastest = fastest_law(path);
      if (min_periods(fastest, rate_hz) > periods) return std::nullopt;
    }
    velocity = std::min(next, kMaxPathVelocity);
  }
  velocity = kMaxPathVelocity;
  return QuantizedLaw{std::move(fastest), periods};
}

SampledLaw sample_law(const ConstrainedPath& path, const QuantizedLaw& quantized, double rate_hz) {
  const Eigen::Index arrival = quantized.periods, periods = arrival + quantized.rest;
  const double dt = 1 / rate_hz;
  const double time_scale = quantized.law.duration_s / (static_cast<double>(arrival - 2) * dt);
  Eigen::ArrayXd c(periods + 3);  // c[k] belongs to instant k - 1
  for (Eigen::Index k = 0; k <= periods + 2; ++k) {
    const double time_s = static_cast<double>(k - 2) * dt * time_scale;
    c[k] = k <= 2 ? 0 : k >= arrival ? path.spline.duration_s : quantized.law.clock_at(time_s);
  }
  SampledLaw sampled;
  Trajectory& out = sampled.trajectory;
  const Eigen::Index n = path.spline.coefficient.cols();
  out.position.resize(periods + 1, n);
  out.velocity = out.acceleration = JointRows::Zero(periods + 1, n);
  JointRows q;
  for (Eigen::Index i = 0; i <= periods; ++i) {
    const double u = (c[i] + 4 * c[i + 1] + c[i + 2]) / 6;
    const double rate = 0.5 * (c[i + 2] - c[i]) * rate_hz;
    const double bend = (c[i] - 2 * c[i + 1] + c[i + 2]) * rate_hz * rate_hz;
    math::evaluate(path.spline, u, q);
    out.position.row(i) = q.row(0);
    if (i > 0 && i < periods) {
      out.velocity.row(i) = q.row(1) * rate;
      out.acceleration.row(i) = q.row(2) * (rate * rate) + q.row(1) * bend;
    }
    sampled.clock.push_back(u);
    const double demonstrated_s = demonstration_time_at(path.parameterized, u);
    out.time.push_back(static_cast<double>(i) * dt);
    out.demonstration_time.push_back(
        i == 0 ? demonstrated_s : std::max(demonstrated_s, out.demonstration_time.back()));
    out.origin.push_back(origin_at(path.parameterized, u));
    // The last instant belongs to the phase that ends there, regardless of rounding.
    const Movement& movement = *path.movement;
    const double time_s = out.demonstration_time.back();
    const bool last =
        movement.end_s > movement.begin_s && std::abs(time_s - movement.end_s) < kEndTolerance_s;
    const double inside_s = last ? movement.end_s - kEndTolerance_s : time_s;
    out.phase.push_back(phase_at(movement.phases, inside_s));
    out.clearance.push_back(kUnknown);
  }
  return sampled;
}

}  // namespace morphe::retime
