#include "stages/retime/time_law.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/jerk_bound.hpp"

namespace morphe::retime {
namespace {

constexpr double kRamp_s = 0.25;  ///< of the path parameter at both ends
constexpr double kAboveGrid = 8;  ///< times the grid law's pace: cap on dw/dt in the ramps
constexpr double kMostCatchUp = 0.4, kMadeUpFor = 0.05;
constexpr double kCatchUp_s = 0.2;
constexpr int kPaces = 11;  ///< tried for a duration, below the fastest
constexpr Eigen::Index kLeastSteps = 400, kStepsPerKnot = 4, kLeastKnots = 32;

}  // namespace

TimeLaw fastest_law(const PacedPath& paced_path, Eigen::Index grid_steps, Eigen::Index knots) {
  const PaceGrid grid = pace_grid(paced_path, grid_steps);
  GridLaw fastest = grid_law(grid.step, fastest_squares(grid));
  const double duration_s = fastest.time[grid_steps];
  if (!(paced_path.jerk.minCoeff() < std::numeric_limits<double>::infinity())) {
    return {duration_s, [law = std::move(fastest)](double t) { return clock_at(law, t); }};
  }
  const RampedClock clock = ramp_ends(paced_path.spline.length, kRamp_s);
  const double most = kAboveGrid * std::sqrt(fastest.square.maxCoeff());
  ProgressLaw law =
      progress_law(clock, fastest_progress(paced_path, clock, knots, most, duration_s));
  const double longer_s = law.time.back();
  return {longer_s, [law = std::move(law)](double t) { return clock_at(law, t); }};
}

TimeLaw fastest_law(const PacedPath& paced_path) {
  const Eigen::Index knots = paced_path.spline.intervals;
  return fastest_law(paced_path, std::max(kLeastSteps, kStepsPerKnot * knots),
                     std::max(kLeastKnots, knots));
}

Eigen::Index least_periods(const TimeLaw& law, double rate_hz) {
  return std::max<Eigen::Index>(
             1, static_cast<Eigen::Index>(std::ceil(law.duration_s * rate_hz - 1e-9))) +
         2;
}

PacedLaw pace_fastest(PacedPath& paced_path, double rate_hz) {
  paced_path.tempo = kMostPace;
  TimeLaw law = fastest_law(paced_path);
  const Eigen::Index periods = least_periods(law, rate_hz);
  return {std::move(law), periods};
}

PacedLaw pace_human(PacedPath& paced_path, double rate_hz) {
  const double length_s = paced_path.spline.length;
  const auto wanted = static_cast<Eigen::Index>(std::lround(length_s * rate_hz));
  paced_path.tempo = 1;
  paced_path.catch_up_s = std::min(kCatchUp_s, 0.5 * length_s);
  PacedLaw first;
  for (paced_path.catch_up = 0; paced_path.catch_up < kMostCatchUp;) {
    PacedLaw paced;
    paced.law = fastest_law(paced_path);
    paced.periods = least_periods(paced.law, rate_hz);
    if (paced.periods <= wanted) {
      paced.periods = wanted;
      return paced;
    }
    const double late_s = static_cast<double>(paced.periods - wanted) / rate_hz;
    const bool again = wanted > 2 && late_s < kMadeUpFor * length_s;
    if (paced_path.catch_up == 0) first = std::move(paced);
    if (!again) break;
    paced_path.catch_up += late_s / paced_path.catch_up_s + 1e-3;
  }
  return first;
}

std::optional<PacedLaw> pace_duration(PacedPath& paced_path, double rate_hz, Eigen::Index periods) {
  if (periods <= 2) return std::nullopt;
  const double steady = paced_path.spline.length * rate_hz / static_cast<double>(periods - 2);
  paced_path.tempo = paced_path.tempo < kMostPace ? std::max(paced_path.tempo, steady) : steady;
  TimeLaw fastest;
  for (int k = 0; k < kPaces; ++k) {
    TimeLaw law = fastest_law(paced_path);
    const Eigen::Index least = least_periods(law, rate_hz);
    if (least <= periods) return PacedLaw{std::move(law), periods};
    const double next =
        paced_path.tempo * 1.01 * static_cast<double>(least) / static_cast<double>(periods);
    if (k == 0) {  // Is there any pace that is fast enough?
      paced_path.tempo = kMostPace;
      fastest = fastest_law(paced_path);
      if (least_periods(fastest, rate_hz) > periods) return std::nullopt;
    }
    paced_path.tempo = std::min(next, kMostPace);
  }
  paced_path.tempo = kMostPace;
  return PacedLaw{std::move(fastest), periods};
}

SampledLaw sample_law(const PacedPath& paced_path, const PacedLaw& paced, double rate_hz) {
  const Eigen::Index arrival = paced.periods, periods = arrival + paced.rest;
  const double dt = 1 / rate_hz;
  const double faster = paced.law.duration_s / (static_cast<double>(arrival - 2) * dt);
  Eigen::ArrayXd c(periods + 3);  // c[k] belongs to instant k - 1
  for (Eigen::Index k = 0; k <= periods + 2; ++k) {
    const double time_s = static_cast<double>(k - 2) * dt * faster;
    c[k] = k <= 2 ? 0 : k >= arrival ? paced_path.spline.length : paced.law.clock_at(time_s);
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
    const double demonstrated_s = demonstration_time_at(paced_path.clocked, u);
    out.time.push_back(static_cast<double>(i) * dt);
    out.demonstration_time.push_back(
        i == 0 ? demonstrated_s : std::max(demonstrated_s, out.demonstration_time.back()));
    out.origin.push_back(origin_at(paced_path.clocked, u));
    out.phase.push_back(phase_at(paced_path.movement->phases, out.demonstration_time.back()));
    out.clearance.push_back(kNotSeen);
  }
  return sampled;
}

}  // namespace morphe::retime
