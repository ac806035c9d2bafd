#pragma once

#include <functional>
#include <optional>

#include "stages/retime/paced_path.hpp"

namespace morphe::retime {

/// The clock as a function of time, from rest to rest.
struct TimeLaw {
  double duration_s = 0;
  std::function<double(double)> clock_at;  ///< u at a time, not decreasing; the ends beyond them
};

/// The fastest law within the path's limits: reachability analysis for velocity and acceleration;
/// where a joint's jerk is bounded, the fastest smooth progress within that too.
/// grid_steps, knots: of the two; fewer are coarser and faster.
TimeLaw fastest_law(const PacedPath& paced_path, Eigen::Index grid_steps, Eigen::Index knots);
/// With as many steps as the path's spline needs.
TimeLaw fastest_law(const PacedPath& paced_path);

/// A law and how many periods its samples take: sample_law() stretches it to that.
struct PacedLaw {
  TimeLaw law;
  Eigen::Index periods = 0;
  Eigen::Index rest = 0;  ///< further periods, at rest at the end
};
constexpr double kMostPeriods = 1e12;  ///< more are told as so many
/// Periods that a law's samples take at least.
Eigen::Index least_periods(const TimeLaw& law, double rate_hz);

/// As fast as the limits allow.
PacedLaw pace_fastest(PacedPath& paced_path, double rate_hz);
/// du/dt <= 1. Being late by up to 5 % (starting and stopping take time that the demonstration may
/// not have taken) is made up for next to both ends, by up to 1.4 times that pace, if limits allow.
PacedLaw pace_human(PacedPath& paced_path, double rate_hz);
/// du/dt <= 1 where it is on time; where the limits made it late, up to 1.4 afterwards until it is
/// on time again.
PacedLaw pace_kept(PacedPath& paced_path, double rate_hz);
/// As human as can be, a steady pace faster or slower, so that all takes so many periods; nothing
/// if even the fastest law takes longer. A path that was paced so before and slowed down since
/// needs no less than the tempo it was left with, and starts from that.
std::optional<PacedLaw> pace_duration(PacedPath& paced_path, double rate_hz, Eigen::Index periods);

/// Samples of the law: c_k = u at the sample instants, stretched to `periods` - 2 and with a period
/// of rest at each end, are the coefficients of a cubic B-spline in time with its knots at the
/// instants; `rest` more lie at the end. It averages the law over neighbouring periods: no
/// velocity, acceleration or jerk grows, acceleration is continuous and linear between the
/// instants, and both ends are at rest. The quintics between samples of q(u(t)) then follow it
/// closely: no switch lies between them.
struct SampledLaw {
  Trajectory trajectory;
  std::vector<double> clock;  ///< u at the samples
};
SampledLaw sample_law(const PacedPath& paced_path, const PacedLaw& paced, double rate_hz);

}  // namespace morphe::retime
