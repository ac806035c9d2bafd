#include "stages/retime/time_law.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/jerk_bound.hpp"

namespace morphe::retime {
namespace {

constexpr double kRamp_s = 0.25;  ///< length of the path parameter's ramp at both ends
/// cap of dw/dt in the ramps, relative to the path velocity of the grid law
constexpr double kMaxRampVelocityRatio = 8;
constexpr double kMaxSpeedupShare = 0.4, kMaxRecoverableDelayShare = 0.05;
constexpr double kSpeedupTime_s = 0.2;
constexpr int kPaceCount = 11;  ///< maximum number of path velocities tried for a duration
constexpr Eigen::Index kMinGridSteps = 400, kStepsPerKnot = 4, kMinKnots = 32;

constexpr int kSpeedupRounds = 4;             ///< rounds of determining the speedups
constexpr double kAtVelocityCapRatio = 0.98;  ///< share of the nominal path velocity

/// Returns the speedups by which a law recovers its delay. In cells in which the limits hold it
/// below its nominal path velocity it is taken to keep its velocity, in the others to be at 1 +
/// min(1.4 - 1, late / kSpeedupTime_s).
std::vector<double> catch_up_speedups(const ConstrainedPath& paced_path, const TimeLaw& law,
                                      double rate_hz) {
  const std::size_t cells = paced_path.slowdown.size();
  const double cell_s = paced_path.spline.duration_s / static_cast<double>(cells);
  std::vector<double> arrival(cells + 1, law.duration_s);  // at the edges of the cells
  arrival[0] = 0;
  std::size_t next = 1;
  double before = 0;
  for (double t = 1 / rate_hz; t < law.duration_s && next < cells; t += 1 / rate_hz) {
    const double u = law.clock_at(t);
    for (; next < cells && u >= static_cast<double>(next) * cell_s; ++next) {
      const double share = (static_cast<double>(next) * cell_s - before) / (u - before);
      arrival[next] = t - (1 - share) / rate_hz;
    }
    before = u;
  }
  std::vector<double> hurry(cells, 0);
  double late_s = 0;
  for (std::size_t k = 0; k < cells; ++k) {
    const double had = paced_path.speedup.empty() ? 0 : paced_path.speedup[k];
    const double pace = cell_s / std::max(arrival[k + 1] - arrival[k], 1e-9);
    hurry[k] = std::clamp(late_s / kSpeedupTime_s, 0.0, kMaxSpeedupShare);
    const bool held = pace < kAtVelocityCapRatio * (1 + had);
    late_s += cell_s / (held ? std::min(pace, 1 + hurry[k]) : 1 + hurry[k]) - cell_s;
  }
  return hurry;
}

}  // namespace

TimeLaw fastest_law(const ConstrainedPath& paced_path, Eigen::Index grid_steps,
                    Eigen::Index knots) {
  const PathGrid grid = path_grid(paced_path, grid_steps);
  GridLaw fastest = grid_law(grid.step, fastest_squared_velocities(grid));
  const double duration_s = fastest.time[grid_steps];
  if (!(paced_path.jerk.minCoeff() < std::numeric_limits<double>::infinity())) {
    return {duration_s, [law = std::move(fastest)](double t) { return clock_at(law, t); }};
  }
  const RampedParameter clock = ramp_ends(paced_path.spline.duration_s, kRamp_s);
  const double most = kMaxRampVelocityRatio * std::sqrt(fastest.square.maxCoeff());
  SplineLaw law =
      spline_law(clock, fastest_squared_velocity(paced_path, clock, knots, most, duration_s));
  const double longer_s = law.time.back();
  return {longer_s, [law = std::move(law)](double t) { return clock_at(law, t); }};
}

TimeLaw fastest_law(const ConstrainedPath& paced_path) {
  const Eigen::Index knots = paced_path.spline.intervals;
  return fastest_law(paced_path, std::max(kMinGridSteps, kStepsPerKnot * knots),
                     std::max(kMinKnots, knots));
}

Eigen::Index min_periods(const TimeLaw& law, double rate_hz) {
  return std::max<Eigen::Index>(
             1, static_cast<Eigen::Index>(
                    std::min(kMaxPeriodCount, std::ceil(law.duration_s * rate_hz - 1e-9)))) +
         2;
}

QuantizedLaw fastest_mode_law(ConstrainedPath& paced_path, double rate_hz) {
  paced_path.nominal_path_velocity = kMaxPathVelocity;
  TimeLaw law = fastest_law(paced_path);
  const Eigen::Index periods = min_periods(law, rate_hz);
  return {std::move(law), periods};
}

QuantizedLaw human_mode_law(ConstrainedPath& paced_path, double rate_hz) {
  const double length_s = paced_path.spline.duration_s;
  const auto wanted = static_cast<Eigen::Index>(std::lround(length_s * rate_hz));
  paced_path.nominal_path_velocity = 1;
  paced_path.end_speedup_s = std::min(kSpeedupTime_s, 0.5 * length_s);
  QuantizedLaw first;
  for (paced_path.end_speedup = 0; paced_path.end_speedup < kMaxSpeedupShare;) {
    QuantizedLaw quantized;
    quantized.law = fastest_law(paced_path);
    quantized.periods = min_periods(quantized.law, rate_hz);
    if (quantized.periods <= wanted) {
      quantized.periods = wanted;
      return quantized;
    }
    const double late_s = static_cast<double>(quantized.periods - wanted) / rate_hz;
    const bool again = wanted > 2 && late_s < kMaxRecoverableDelayShare * length_s;
    if (paced_path.end_speedup == 0) first = std::move(quantized);
    if (!again) break;
    paced_path.end_speedup += late_s / paced_path.end_speedup_s + 1e-3;
  }
  return first;
}

QuantizedLaw catch_up_mode_law(ConstrainedPath& paced_path, double rate_hz) {
  const auto wanted =
      static_cast<Eigen::Index>(std::lround(paced_path.spline.duration_s * rate_hz));
  paced_path.nominal_path_velocity = 1;
  paced_path.speedup.clear();
  QuantizedLaw quantized;
  for (int k = 0; k < kSpeedupRounds; ++k) {
    if (k > 0) paced_path.speedup = catch_up_speedups(paced_path, quantized.law, rate_hz);
    quantized.law = fastest_law(paced_path);
  }
  quantized.periods = std::max(min_periods(quantized.law, rate_hz), wanted);
  return quantized;
}

std::optional<QuantizedLaw> duration_mode_law(ConstrainedPath& paced_path, double rate_hz,
                                              Eigen::Index periods) {
  if (periods <= 2) return std::nullopt;
  const double steady = paced_path.spline.duration_s * rate_hz / static_cast<double>(periods - 2);
  paced_path.nominal_path_velocity = paced_path.nominal_path_velocity < kMaxPathVelocity
                                         ? std::max(paced_path.nominal_path_velocity, steady)
                                         : steady;
  TimeLaw fastest;
  for (int k = 0; k < kPaceCount; ++k) {
    TimeLaw law = fastest_law(paced_path);
    const Eigen::Index least = min_periods(law, rate_hz);
    if (least <= periods) return QuantizedLaw{std::move(law), periods};
    const double next = paced_path.nominal_path_velocity * 1.01 * static_cast<double>(least) /
                        static_cast<double>(periods);
    if (k == 0) {  // checks if any path velocity is fast enough
      paced_path.nominal_path_velocity = kMaxPathVelocity;
      fastest = fastest_law(paced_path);
      if (min_periods(fastest, rate_hz) > periods) return std::nullopt;
    }
    paced_path.nominal_path_velocity = std::min(next, kMaxPathVelocity);
  }
  paced_path.nominal_path_velocity = kMaxPathVelocity;
  return QuantizedLaw{std::move(fastest), periods};
}

constexpr double kEndTolerance_s = 1e-9;  ///< end of a movement, up to rounding

SampledLaw sample_law(const ConstrainedPath& paced_path, const QuantizedLaw& paced,
                      double rate_hz) {
  const Eigen::Index arrival = paced.periods, periods = arrival + paced.rest;
  const double dt = 1 / rate_hz;
  const double faster = paced.law.duration_s / (static_cast<double>(arrival - 2) * dt);
  Eigen::ArrayXd c(periods + 3);  // c[k] belongs to instant k - 1
  for (Eigen::Index k = 0; k <= periods + 2; ++k) {
    const double time_s = static_cast<double>(k - 2) * dt * faster;
    c[k] = k <= 2 ? 0 : k >= arrival ? paced_path.spline.duration_s : paced.law.clock_at(time_s);
  }
  SampledLaw sampled;
  Trajectory& out = sampled.trajectory;
  const Eigen::Index n = paced_path.spline.coefficient.cols();
  out.position.resize(periods + 1, n);
  out.velocity = out.acceleration = JointRows::Zero(periods + 1, n);
  JointRows q;
  for (Eigen::Index i = 0; i <= periods; ++i) {
    const double u = (c[i] + 4 * c[i + 1] + c[i + 2]) / 6;
    const double rate = 0.5 * (c[i + 2] - c[i]) * rate_hz;
    const double bend = (c[i] - 2 * c[i + 1] + c[i + 2]) * rate_hz * rate_hz;
    math::evaluate(paced_path.spline, u, q);
    out.position.row(i) = q.row(0);
    if (i > 0 && i < periods) {
      out.velocity.row(i) = q.row(1) * rate;
      out.acceleration.row(i) = q.row(2) * (rate * rate) + q.row(1) * bend;
    }
    sampled.clock.push_back(u);
    const double demonstrated_s = demonstration_time_at(paced_path.parameterized, u);
    out.time.push_back(static_cast<double>(i) * dt);
    out.demonstration_time.push_back(
        i == 0 ? demonstrated_s : std::max(demonstrated_s, out.demonstration_time.back()));
    out.origin.push_back(origin_at(paced_path.parameterized, u));
    // The last instant belongs to the phase that ends there, regardless of rounding.
    const Movement& movement = *paced_path.movement;
    const double time_s = out.demonstration_time.back();
    const bool last =
        movement.end_s > movement.begin_s && std::abs(time_s - movement.end_s) < kEndTolerance_s;
    out.phase.push_back(
        phase_at(movement.phases, last ? movement.end_s - kEndTolerance_s : time_s));
    out.clearance.push_back(kUnknown);
  }
  return sampled;
}

}  // namespace morphe::retime
