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

constexpr int kHurries = 4;              ///< rounds of finding where to hurry
constexpr double kReachesItsCap = 0.98;  ///< of the tempo that it may have

/// Where a law is late it may hurry after that: as it is paced in the cells where the limits hold
/// it below its tempo, in the others at 1 + min(1.4 - 1, late / kCatchUp_s).
std::vector<double> where_late(const PacedPath& paced_path, const TimeLaw& law, double rate_hz) {
  const std::size_t cells = paced_path.slowdown.size();
  const double cell_s = paced_path.spline.length / static_cast<double>(cells);
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
    const double had = paced_path.hurry.empty() ? 0 : paced_path.hurry[k];
    const double pace = cell_s / std::max(arrival[k + 1] - arrival[k], 1e-9);
    hurry[k] = std::clamp(late_s / kCatchUp_s, 0.0, kMostCatchUp);
    const bool held = pace < kReachesItsCap * (1 + had);
    late_s += cell_s / (held ? std::min(pace, 1 + hurry[k]) : 1 + hurry[k]) - cell_s;
  }
  return hurry;
}

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
  return std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::min(
                                       kMostPeriods, std::ceil(law.duration_s * rate_hz - 1e-9)))) +
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

PacedLaw pace_kept(PacedPath& paced_path, double rate_hz) {
  const auto wanted = static_cast<Eigen::Index>(std::lround(paced_path.spline.length * rate_hz));
  paced_path.tempo = 1;
  paced_path.hurry.clear();
  PacedLaw paced;
  for (int k = 0; k < kHurries; ++k) {
    if (k > 0) paced_path.hurry = where_late(paced_path, paced.law, rate_hz);
    paced.law = fastest_law(paced_path);
  }
  paced.periods = std::max(least_periods(paced.law, rate_hz), wanted);
  return paced;
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

constexpr double kEnd_s = 1e-9;  ///< of a movement, to rounding

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
    // The last instant is in the phase that ends there, whatever rounding made of it.
    const Movement& movement = *paced_path.movement;
    const double time_s = out.demonstration_time.back();
    const bool last =
        movement.end_s > movement.begin_s && std::abs(time_s - movement.end_s) < kEnd_s;
    out.phase.push_back(phase_at(movement.phases, last ? movement.end_s - kEnd_s : time_s));
    out.clearance.push_back(kNotSeen);
  }
  return sampled;
}

}  // namespace morphe::retime
