#include "stages/retime/retime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pipeline/motion/quintic.hpp"
#include "stages/retime/joint_spline.hpp"
#include "stages/retime/path_clock.hpp"
#include "stages/retime/progress.hpp"

namespace morphe {
namespace {

constexpr double kKnotStep_s = 0.01;  ///< of the path's spline and of the progress
constexpr double kRamp_s = 0.25;      ///< of the path parameter at both ends
constexpr int kCellsPerKnot = 4;      ///< of the table of times
/// A tolerance of zero: only as much as keeps the spline from ringing between samples.
constexpr SmoothingAt kExact{0.003, 1e-5};
constexpr int kSlowdowns = 12;
constexpr double kBearable = 1.5;

/// t(w) at the edges of equal cells: the integral of x^(-1/2), by Gauss–Legendre.
struct TimeTable {
  const Progress* progress = nullptr;
  double cell = 0;
  std::vector<double> time;
};

double duration_between(const Progress& progress, double from, double to) {
  constexpr std::array<double, 5> node{
      -0.906179845938663992797626878299, -0.538469310105683091036314420700, 0,
      0.538469310105683091036314420700, 0.906179845938663992797626878299};
  constexpr std::array<double, 5> weight{
      0.236926885056189087514264040720, 0.478628670499366468041291514836,
      0.568888888888888888888888888889, 0.478628670499366468041291514836,
      0.236926885056189087514264040720};
  const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
  double sum = 0;
  for (std::size_t k = 0; k < node.size(); ++k) {
    sum += weight[k] / std::sqrt(evaluate(progress, middle + half * node[k]).x);
  }
  return half * sum;
}

TimeTable time_table(const Progress& progress) {
  const Eigen::Index cells = kCellsPerKnot * (progress.coefficient.size() - 3);
  TimeTable table{&progress, progress.length / static_cast<double>(cells), {0}};
  for (Eigen::Index i = 0; i < cells; ++i) {
    const double from = static_cast<double>(i) * table.cell;
    table.time.push_back(table.time.back() + duration_between(progress, from, from + table.cell));
  }
  return table;
}

/// w at a time: Newton on t(w) within its cell.
double progress_at(const TimeTable& table, double time_s) {
  const auto after = std::upper_bound(table.time.begin(), table.time.end(), time_s);
  if (after == table.time.end()) return table.progress->length;
  const auto i = static_cast<std::size_t>(after - table.time.begin()) - 1;
  const double from = static_cast<double>(i) * table.cell;
  double w = from;
  for (int step = 0; step < 8; ++step) {
    const double off = time_s - table.time[i] - duration_between(*table.progress, from, w);
    const double move = off * std::sqrt(evaluate(*table.progress, w).x);
    w = std::clamp(w + move, from, from + table.cell);
    if (std::abs(move) < 1e-16) break;
  }
  return w;
}

bool positive(const Progress& progress) {
  for (Eigen::Index i = 0; i < 32 * (progress.coefficient.size() - 3); ++i) {
    const double w = static_cast<double>(i) / 32 * progress.length /
                     static_cast<double>(progress.coefficient.size() - 3);
    if (!(evaluate(progress, w).x > 1e-12)) return false;
  }
  return true;
}

/// Samples the law, slowed down by at least `slowdown` (the duration is whole periods).
Trajectory sample(const RampedPath& path, const TimeTable& table, const ClockedPath& clocked,
                  const Movement& movement, double slowdown, double rate_hz) {
  const double fastest_s = table.time.back();
  const auto periods = std::max<Eigen::Index>(
      2, static_cast<Eigen::Index>(std::ceil(slowdown * fastest_s * rate_hz - 1e-9)));
  const double stretch = static_cast<double>(periods) / rate_hz / fastest_s;
  Trajectory out;
  out.position.resize(periods + 1, path.spline->coefficient.cols());
  out.velocity = out.acceleration = JointRows::Zero(periods + 1, out.position.cols());
  JointRows q;
  for (Eigen::Index i = 0; i <= periods; ++i) {
    const double time_s = static_cast<double>(i) / rate_hz;
    const bool end = i == 0 || i == periods;
    const double w = i == 0 ? 0 : i == periods ? path.length : progress_at(table, time_s / stretch);
    evaluate(path, w, q);
    const ProgressAt at = evaluate(*table.progress, w);
    out.position.row(i) = q.row(0);
    if (!end) {
      out.velocity.row(i) = q.row(1) * (std::sqrt(at.x) / stretch);
      out.acceleration.row(i) = (q.row(2) * at.x + q.row(1) * (0.5 * at.d1)) / (stretch * stretch);
    }
    const double u = clock_at(path, w).u;
    out.time.push_back(time_s);
    out.demonstration_time.push_back(demonstration_time_at(clocked, u));
    out.origin.push_back(origin_at(clocked, u));
    out.phase.push_back(
        static_cast<std::uint8_t>(phase_at(movement.phases, out.demonstration_time.back())));
    out.clearance.push_back(kNotSeen);
  }
  for (std::size_t i = 1; i < out.demonstration_time.size(); ++i) {
    out.demonstration_time[i] = std::max(out.demonstration_time[i], out.demonstration_time[i - 1]);
  }
  return out;
}

/// Slows the law down as a whole until it holds on the quintics; false if it never does.
bool sample_within_limits(const RobotTable& robot, const RampedPath& path,
                          const ClockedPath& clocked, const Movement& movement,
                          const Progress& progress, const RetimeOptions& options,
                          Trajectory& trajectory) {
  const TimeTable table = time_table(progress);
  double slowdown = 1;
  for (int round = 0; round < kSlowdowns; ++round) {
    trajectory = sample(path, table, clocked, movement, slowdown, options.sample_rate_hz);
    const LimitReport use = judge_limits(robot, trajectory);
    const double share = options.limit_share;
    const double needed =
        std::max({use.velocity.ratio / share, std::sqrt(use.acceleration.ratio / share),
                  std::cbrt(use.jerk.ratio / share)});
    if (!std::isfinite(needed)) return false;
    if (needed <= 1) return true;
    slowdown = trajectory.time.back() / table.time.back() * needed * (1 + 1e-6);
  }
  return false;
}

std::vector<SmoothingAt> smoothing_of(const ClockedPath& path, const RetimeOptions& options) {
  std::vector<SmoothingAt> out;
  for (const Origin origin : path.origin) {
    const double factor = origin == Origin::planned ? options.planned_smoothing : 1;
    const SmoothingAt at{factor * options.smoothing_s, factor * options.smoothing_tolerance};
    out.push_back(at.tolerance > kExact.tolerance ? at : kExact);
  }
  return out;
}

std::string what_is_wrong(const RobotTable& robot, const JointPath& path) {
  const auto samples = path.demonstration_time.size();
  if (samples == 0) return "the path has no samples";
  if (path.position.rows() != static_cast<Eigen::Index>(samples) || path.origin.size() != samples ||
      path.position.cols() != static_cast<Eigen::Index>(robot.joints())) {
    return "the path's arrays do not fit each other or the robot";
  }
  if (!path.position.allFinite()) return "the path holds positions that are not numbers";
  for (std::size_t i = 0; i < samples; ++i) {
    const double step = i > 0 ? path.demonstration_time[i] - path.demonstration_time[i - 1] : 0;
    if (!std::isfinite(path.demonstration_time[i]) || step < 0) {
      return fmt::format("the path's demonstration time decreases at sample {}", i);
    }
  }
  return "";
}

/// Samples are drawn onto a limit that they exceed by no more than rounding.
std::string what_is_beyond_limits(const RobotTable& robot, const JointPath& path) {
  constexpr double kRounding = 1e-4;  ///< [rad]
  for (Eigen::Index i = 0; i < path.position.rows(); ++i) {
    for (Eigen::Index joint = 0; joint < path.position.cols(); ++joint) {
      const double q = path.position(i, joint);
      const double beyond = std::max(robot.lower[joint] - q, q - robot.upper[joint]);
      if (beyond <= kRounding) continue;
      return fmt::format("joint {} is {:.3g} rad beyond its limit at path sample {}",
                         robot.joint_names[static_cast<std::size_t>(joint)], beyond, i);
    }
  }
  return "";
}

}  // namespace

std::string check(const RetimeOptions& o) {
  if (!(o.sample_rate_hz >= 10)) return "sample_rate_hz must be at least 10";
  if (!(o.limit_share > 0 && o.limit_share <= 1)) return "limit_share must lie in (0, 1]";
  if (!(o.tempo_cap > 0)) return "tempo_cap must be positive";
  if (!(o.smoothing_s >= 0)) return "smoothing_s must not be negative";
  if (!(o.smoothing_tolerance >= 0)) return "smoothing_tolerance must not be negative";
  if (!(o.planned_smoothing >= 0)) return "planned_smoothing must not be negative";
  return "";
}

RetimeResult retime(const RobotTable& robot, const JointPath& path, const Movement& movement,
                    const RetimeOptions& options) {
  RetimeResult result;
  result.detail = what_is_wrong(robot, path);
  if (!result.detail.empty()) {
    result.reason = "path";
    return result;
  }
  result.detail = what_is_beyond_limits(robot, path);
  if (!result.detail.empty()) {
    result.reason = "limit";
    return result;
  }
  const ClockedPath given = clock_path(robot, path, kKnotStep_s);
  const JointSpline smooth = fit_spline(given.clock, given.position, smoothing_of(given, options),
                                        robot.lower, robot.upper, kKnotStep_s);
  const ClockedPath clocked = stretch_clock(robot, given, smooth, kBearable);
  const std::vector<SmoothingAt> exact(clocked.clock.size(), {0, kExact.tolerance});
  const JointSpline spline =
      fit_spline(clocked.clock, clocked.position, exact, robot.lower, robot.upper, kKnotStep_s);
  result.path_deviation = deviation(smooth, given.clock, given.position) +
                          deviation(spline, clocked.clock, clocked.position);
  const RampedPath ramped = ramp_ends(spline, kRamp_s);
  const Progress fastest =
      fastest_progress(robot, ramped, clocked, options.limit_share, options.tempo_cap, kKnotStep_s);
  if (positive(fastest) &&
      sample_within_limits(robot, ramped, clocked, movement, fastest, options, result.trajectory)) {
    return result;
  }
  const Progress steady =
      steady_progress(robot, ramped, clocked, options.limit_share, options.tempo_cap, kKnotStep_s);
  if (sample_within_limits(robot, ramped, clocked, movement, steady, options, result.trajectory)) {
    return result;
  }
  result.trajectory = {};
  result.reason = "limit";
  result.detail = "no slowdown brings the path within the joints' velocity, acceleration and jerk";
  return result;
}

}  // namespace morphe
