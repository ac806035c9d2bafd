#include "stages/retime/retime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/math/braking.hpp"
#include "core/math/quintic.hpp"
#include "core/motion/finding_text.hpp"
#include "core/robot/joint_unit.hpp"
#include "stages/retime/constants.hpp"
#include "stages/retime/fit_path.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::retime {
namespace {

std::string path_error(const RobotModel& robot, const JointPath& path) {
  const auto samples = std::ssize(path.demonstration_time);
  if (samples == 0) return "the path has no samples";
  if (path.position.rows() != samples || std::ssize(path.origin) != samples ||
      path.position.cols() != std::ssize(robot.joint_names))
    return "the sizes of the path's arrays do not match each other or the robot";
  if (!path.position.allFinite()) return "the path contains positions that are not finite numbers";
  for (int i = 0; i < samples; ++i) {
    const double step = i > 0 ? path.demonstration_time[i] - path.demonstration_time[i - 1] : 0;
    if (!std::isfinite(path.demonstration_time[i]) || step < 0)
      return fmt::format("the path's demonstration time decreases at sample {}", i);
  }
  return "";
}

/// Returns a description of invalid limits or of a sample beyond a limit, or "".
std::string limit_violation(const RobotModel& robot, const JointPath& path) {
  for (int joint = 0; joint < path.position.cols(); ++joint) {
    const std::string& name = robot.joint_names[joint];
    if (!(robot.velocity[joint] > 0 && robot.acceleration[joint] > 0 && robot.jerk[joint] > 0))
      return fmt::format("joint {}: its limits of velocity, acceleration and jerk must be above 0",
                         name);
    if (!(robot.lower[joint] <= robot.upper[joint]))
      return fmt::format("joint {} has no range of positions", name);
    for (int i = 0; i < path.position.rows(); ++i) {
      const double q = path.position(i, joint);
      const double beyond = std::max(robot.lower[joint] - q, q - robot.upper[joint]);
      if (!(beyond <= kLimitRounding_rad))
        return fmt::format("joint {} is {} beyond its limit at path sample {}", name,
                           amount_text(beyond, robot::joint_unit(robot, joint)), i);
    }
  }
  return "";
}

/// Returns the factors on the tolerances of smoothing: `planned_factor` where the path was planned,
/// and kHeldSmoothingFactor while the hand holds a target that it carries, lest its pads move.
std::vector<double> smoothing_allowance(const ParameterizedPath& path, const Movement& movement,
                                        double planned_factor) {
  const HeldInterval held = held_interval(movement);
  std::vector<double> allowance;
  for (std::size_t i = 0; i < path.origin.size(); ++i) {
    const double factor = path.origin[i] == SampleOrigin::planned ? planned_factor : 1;
    allowance.push_back(held.contains(path.demonstration_time[i]) ? kHeldSmoothingFactor : factor);
  }
  return allowance;
}

ConstrainedPath make_constrained_path(const RobotModel& robot, const JointPath& path,
                                      const Movement& movement, const RetimeOptions& options,
                                      bool keep_pauses, RetimeResult& result) {
  ConstrainedPath out;
  out.robot = &robot;
  out.movement = &movement;
  out.parameterized = parameterize_path(robot, path, kKnotStep_s, keep_pauses);
  PathFit fitted =
      fit_path(robot, out.parameterized.parameter, out.parameterized.position,
               smoothing_allowance(out.parameterized, movement, options.planned_smoothing_factor),
               {options.smoothing_s, options.tip_tolerance, options.joint_tolerance}, kKnotStep_s);
  out.spline = std::move(fitted.spline);
  result.tip_deviation = fitted.tip_deviation;
  result.joint_deviation = fitted.joint_deviation;
  out.velocity = options.limit_scaling * robot.velocity;
  out.acceleration = options.limit_scaling * robot.acceleration;
  out.jerk = options.limit_scaling * robot.jerk;
  out.braking_share = options.limit_scaling;
  out.tip_speed = options.max_tip_speed.value_or(kMaxPathVelocity);
  for (const auto& [phase, scale] : options.phase_speed) out.phase_scale[phase] = scale;
  out.slowdown.assign(out.spline.intervals, 1);
  return out;
}

/// Returns the factor by which a step must be slower if its quintic exceeds the joint's range by
/// `beyond_rad`. The path itself keeps half of kLimitInset_rad from the range's ends, and the
/// deviation of a quintic from it is proportional to the sixth power of the step's duration.
double slowdown_within_limits(double beyond_rad) {
  return std::pow(1 + beyond_rad / (0.5 * kLimitInset_rad), 1.0 / 6);
}

/// Returns the factor by which each step must be slower: above 1 if it exceeds a limit, otherwise
/// at most 1, such as 0 for steps that an enclosure proves to be within the limits.
std::vector<double> compute_slowdowns(const ConstrainedPath& path, const Trajectory& trajectory) {
  const RobotModel& robot = *path.robot;
  std::vector<double> out;
  math::Enclosure within;
  for (int i = 0; i + 1 < std::ssize(trajectory.time); ++i) {
    double slowdown = 0;
    for (const RobotModel::BrakingCurve& curve : robot.braking_curves) {
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, curve.joint);
      // The exact value is irrelevant below the limit.
      const double limit = path.braking_share;
      slowdown = std::max(slowdown, math::braking_ratio(curve, piece, limit) / limit);
    }
    math::enclose(trajectory, i, within);
    for (int joint = 0; joint < trajectory.position.cols(); ++joint) {
      const double lower = robot.lower[joint], upper = robot.upper[joint];
      if (within.lowest[joint] >= lower && within.highest[joint] <= upper &&
          within.velocity[joint] <= path.velocity[joint] &&
          within.acceleration[joint] <= path.acceleration[joint] &&
          within.jerk[joint] <= path.jerk[joint])
        continue;
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, joint);
      const double beyond = math::limit_excess(piece, lower, upper);
      const bool fixed = upper - lower < 4 * kLimitInset_rad;  // the fit keeps less than the inset
      if (beyond > 0 && !fixed) slowdown = std::max(slowdown, slowdown_within_limits(beyond));
      const math::QuinticExtremes extremes = math::extremes(piece);
      const auto ratio = [](const math::Range& range, double limit) {
        return std::max(-range.least, range.greatest) / limit;
      };
      slowdown = std::max({slowdown, ratio(extremes.velocity, path.velocity[joint]),
                           std::sqrt(ratio(extremes.acceleration, path.acceleration[joint])),
                           std::cbrt(ratio(extremes.jerk, path.jerk[joint]))});
    }
    out.push_back(slowdown);
  }
  return out;
}

/// Slows the path down at steps that must be slower, and for a few knots around them.
void slow_down(ConstrainedPath& path, const SampledLaw& sampled,
               const std::vector<double>& required_slowdowns) {
  const Eigen::Index cells = std::ssize(path.slowdown);
  const auto cell_of = [&](double u) {
    return static_cast<Eigen::Index>(u / path.spline.duration_s * static_cast<double>(cells));
  };
  std::vector<double> factor(cells, 1);
  for (int i = 0; i < std::ssize(required_slowdowns); ++i) {
    const double required = required_slowdowns[i];
    if (required <= 1) continue;
    const Eigen::Index from = cell_of(sampled.clock[i]) - kSlowdownMarginKnots;
    const Eigen::Index to = cell_of(sampled.clock[i + 1]) + kSlowdownMarginKnots;
    for (Eigen::Index k = std::max<Eigen::Index>(0, from); k <= std::min(cells - 1, to); ++k)
      factor[k] = std::max(factor[k], required * (1 + kLimitMarginRatio));
  }
  for (int k = 0; k < cells; ++k) path.slowdown[k] *= factor[k];
}
struct RetimeAttempt {
  QuantizedLaw law;
  SampledLaw sampled;
  std::vector<double> required_slowdowns;
  double max_slowdown = 0;
};
void sample(const ConstrainedPath& path, double rate_hz, RetimeAttempt& attempt) {
  if (static_cast<double>(attempt.law.periods) > kMaxDuration_s * rate_hz + 2) {
    attempt.max_slowdown = kInfinity;
    return;
  }
  attempt.sampled = sample_law(path, attempt.law, rate_hz);
  attempt.required_slowdowns = compute_slowdowns(path, attempt.sampled.trajectory);
  attempt.max_slowdown = *std::ranges::max_element(attempt.required_slowdowns);
}

using LawFunction = std::function<std::optional<QuantizedLaw>(ConstrainedPath&)>;

/// Samples laws and slows the path down until the quintics respect the limits. Returns false if
/// they do not after kMaxCorrections rounds or if there is no law.
bool retime_within_limits(ConstrainedPath& path, const LawFunction& make_law, double rate_hz,
                          RetimeAttempt& attempt) {
  for (int round = 0; round <= kMaxCorrections; ++round) {
    std::optional<QuantizedLaw> law = make_law(path);
    if (!law) return false;
    attempt.law = std::move(*law);
    sample(path, rate_hz, attempt);
    if (attempt.max_slowdown <= 1) return true;
    if (!std::isfinite(attempt.max_slowdown)) return false;
    // The last rounds slow down the whole path.
    std::vector<double> slowdowns = attempt.required_slowdowns;
    if (2 * round >= kMaxCorrections) std::ranges::fill(slowdowns, attempt.max_slowdown);
    slow_down(path, attempt.sampled, slowdowns);
  }
  return false;
}

/// Does the same, then adds periods to the last law if necessary. Returns false in vain.
bool retime_stretching(ConstrainedPath& path, const LawFunction& make_law, double rate_hz,
                       RetimeAttempt& attempt) {
  if (retime_within_limits(path, make_law, rate_hz, attempt)) return true;
  if (!std::isfinite(attempt.max_slowdown)) return false;
  for (int stretch = 0; attempt.max_slowdown > 1 && stretch < kMaxCorrections; ++stretch) {
    const auto moving = static_cast<double>(attempt.law.periods - 2);
    const double periods = std::min(
        kMaxPeriodCount, std::ceil(moving * attempt.max_slowdown * (1 + kLimitMarginRatio)));
    attempt.law.periods = 2 + std::lround(periods);
    sample(path, rate_hz, attempt);
  }
  return attempt.max_slowdown <= 1;
}

/// Computes a law with a given number of periods. Tries in turn, until one respects the limits:
/// the human's proportions; these without the pauses, which may leave too little time for the
/// motion; the fastest motion, stretched; and, as stretching changes the sampling instants, the
/// fastest motion unchanged, with rest at the end.
bool retime_to_duration(Eigen::Index periods,
                        const std::function<ConstrainedPath(bool keep_pauses)>& make,
                        double rate_hz, RetimeAttempt& attempt) {
  const auto human_law = [&](ConstrainedPath& c) { return duration_mode_law(c, rate_hz, periods); };
  ConstrainedPath path = make(true);
  const double with_pauses_s = path.spline.duration_s;
  if (retime_within_limits(path, human_law, rate_hz, attempt)) return true;
  const ConstrainedPath without_pauses = make(false);
  path = without_pauses;
  const bool pauses = path.spline.duration_s < with_pauses_s;
  if (pauses && retime_within_limits(path, human_law, rate_hz, attempt)) return true;
  path = without_pauses;
  const auto fastest = [&](ConstrainedPath& c) { return fastest_mode_law(c, rate_hz); };
  if (!retime_stretching(path, fastest, rate_hz, attempt)) return false;
  const Eigen::Index fastest_periods = attempt.law.periods;
  if (fastest_periods > periods) return false;
  attempt.law.periods = periods;
  sample(path, rate_hz, attempt);
  if (attempt.max_slowdown <= 1) return true;
  attempt.law.periods = fastest_periods;
  attempt.law.rest = periods - fastest_periods;
  sample(path, rate_hz, attempt);
  return attempt.max_slowdown <= 1;
}

}  // namespace

std::string validation_error(const RetimeOptions& o) {
  if ((o.mode == RetimeMode::duration) != o.duration_s.has_value())
    return "duration_s must be given with mode duration, and only with it";
  return "";
}

Outcome<RetimeResult> retime(const RobotModel& robot, const JointPath& path,
                             const Movement& movement, const RetimeOptions& options) {
  if (std::string error = path_error(robot, path); !error.empty())
    return {{}, {Reason::invalid_path, std::move(error)}};
  if (std::string violation = limit_violation(robot, path); !violation.empty())
    return {{}, {Reason::joint_limit, std::move(violation)}};
  RetimeResult result;
  const double rate_hz = options.sample_rate_hz;
  const auto make = [&](bool keep_pauses) {
    return make_constrained_path(robot, path, movement, options, keep_pauses, result);
  };
  RetimeAttempt attempt;
  if (options.mode == RetimeMode::duration) {
    const double periods = std::floor(*options.duration_s * rate_hz + 1e-9);
    if (!retime_to_duration(static_cast<Eigen::Index>(periods), make, rate_hz, attempt)) {
      return {std::move(result),
              {Reason::duration_too_short,
               fmt::format("the path cannot be followed in {} s", *options.duration_s)}};
    }
  } else {
    const bool human = options.mode == RetimeMode::human,
               catch_up = options.mode == RetimeMode::catch_up;
    ConstrainedPath constrained = make(human || catch_up);
    const auto make_law = [&](ConstrainedPath& c) {
      return catch_up ? catch_up_mode_law(c, rate_hz)
             : human  ? human_mode_law(c, rate_hz)
                      : fastest_mode_law(c, rate_hz);
    };
    if (!retime_stretching(constrained, make_law, rate_hz, attempt)) {
      return {std::move(result),
              {Reason::joint_limit,
               "even a duration of one hour does not keep the path within the joints' limits of "
               "position, velocity, acceleration and jerk"}};
    }
  }
  result.trajectory = std::move(attempt.sampled.trajectory);
  return {std::move(result), {}};
}

}  // namespace morphe::retime
