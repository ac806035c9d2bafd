#include "stages/retime/retime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

#include "core/math/braking.hpp"
#include "core/math/quintic.hpp"
#include "stages/retime/fit_path.hpp"
#include "stages/retime/limited_fit.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::retime {
namespace {

constexpr double kKnotStep_s = 0.01;  ///< maximum knot distance of the path's spline
constexpr int kMaxCorrections = 12;   ///< corrections of the law if the quintics exceed the limits
constexpr double kLimitMarginRatio = 5e-4;  ///< corrections aim this much below the limits
/// knots around an excess that are slowed down with it
constexpr Eigen::Index kSlowdownReachKnots = 4;
constexpr std::size_t kPhases = enum_count<PhaseKind>();

std::string path_error(const RobotModel& robot, const JointPath& path) {
  const auto samples = path.demonstration_time.size();
  if (samples == 0) return "the path has no samples";
  if (path.position.rows() != static_cast<Eigen::Index>(samples) || path.origin.size() != samples ||
      path.position.cols() != static_cast<Eigen::Index>(robot.joints())) {
    return "the sizes of the path's arrays do not match each other or the robot";
  }
  if (!path.position.allFinite()) return "the path contains positions that are not finite numbers";
  for (std::size_t i = 0; i < samples; ++i) {
    const double step = i > 0 ? path.demonstration_time[i] - path.demonstration_time[i - 1] : 0;
    if (!std::isfinite(path.demonstration_time[i]) || step < 0) {
      return fmt::format("the path's demonstration time decreases at sample {}", i);
    }
  }
  return "";
}

/// Returns a description of a sample that exceeds a joint limit by more than rounding, or "";
/// samples within rounding are moved onto the limit.
std::string limit_violation(const RobotModel& robot, const JointPath& path) {
  constexpr double kLimitRounding_rad = 1e-4;  ///< [rad]
  for (Eigen::Index joint = 0; joint < path.position.cols(); ++joint) {
    const std::string& name = robot.joint_names[static_cast<std::size_t>(joint)];
    if (!(robot.velocity[joint] > 0 && robot.acceleration[joint] > 0 && robot.jerk[joint] > 0)) {
      return fmt::format("joint {}: its limits of velocity, acceleration and jerk must be above 0",
                         name);
    }
    if (!(robot.lower[joint] <= robot.upper[joint])) {
      return fmt::format("joint {} has no range of positions", name);
    }
    for (Eigen::Index i = 0; i < path.position.rows(); ++i) {
      const double q = path.position(i, joint);
      const double beyond = std::max(robot.lower[joint] - q, q - robot.upper[joint]);
      if (beyond <= kLimitRounding_rad) continue;
      return fmt::format("joint {} is {:.3g} rad beyond its limit at path sample {}", name, beyond,
                         i);
    }
  }
  return "";
}

ConstrainedPath make_constrained_path(const RobotModel& robot, const JointPath& path,
                                      const Movement& movement, const RetimeOptions& options,
                                      bool keep_pauses, RetimeResult& result) {
  ConstrainedPath paced_path;
  paced_path.robot = &robot;
  paced_path.movement = &movement;
  paced_path.parameterized = parameterize_path(robot, path, kKnotStep_s, keep_pauses);
  std::vector<double> allowance;
  for (const SampleOrigin origin : paced_path.parameterized.origin) {
    allowance.push_back(origin == SampleOrigin::planned ? options.planned_smoothing_factor : 1);
  }
  PathFit fitted = fit_path(
      robot, paced_path.parameterized.parameter, paced_path.parameterized.position, allowance,
      {options.smoothing_s, options.tip_tolerance, options.joint_tolerance}, kKnotStep_s);
  paced_path.spline = std::move(fitted.spline);
  result.tip_deviation = fitted.tip_deviation;
  result.joint_deviation = fitted.joint_deviation;
  paced_path.velocity = options.limit_scaling * robot.velocity;
  paced_path.acceleration = options.limit_scaling * robot.acceleration;
  paced_path.jerk = options.limit_scaling * robot.jerk;
  paced_path.braking_share = options.limit_scaling;
  paced_path.tip_speed = options.max_tip_speed.value_or(kMaxPathVelocity);
  if (!options.phase_speed.empty()) paced_path.phase_scale.assign(kPhases, 1);
  for (const PhaseSpeed& phase : options.phase_speed) {
    paced_path.phase_scale[static_cast<std::size_t>(phase.phase)] = phase.scale;
  }
  paced_path.slowdown.assign(static_cast<std::size_t>(paced_path.spline.intervals), 1);
  return paced_path;
}

/// Returns the factor by which a step must be slower whose quintic exceeds the joint's range by
/// that much although the path does not: the deviation of the quintic from a smooth path between
/// two samples is proportional to the sixth power of the time between them. The path keeps half of
/// kLimitInset_rad from its limits.
double slowdown_within_limits(double beyond_rad) {
  return std::pow(1 + beyond_rad / (0.5 * kLimitInset_rad), 1.0 / 6);
}

/// Returns, for each step between samples, the factor by which it must be slower to respect the
/// path's limits; 0 if it certainly respects them.
std::vector<double> compute_slowdowns(const ConstrainedPath& paced_path,
                                      const Trajectory& trajectory) {
  const RobotModel& robot = *paced_path.robot;
  std::vector<double> out;
  math::Enclosure within;
  for (std::size_t i = 0; i + 1 < trajectory.samples(); ++i) {
    double worst = 0;
    for (const RobotModel::BrakingCurve& curve : robot.braking_curves) {
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, curve.joint);
      // The exact value is irrelevant below the limit.
      const double limit = paced_path.braking_share;
      worst = std::max(worst, math::braking_ratio(curve, piece, limit) / limit);
    }
    math::enclose(trajectory, i, within);
    for (Eigen::Index joint = 0; joint < trajectory.position.cols(); ++joint) {
      const double lower = robot.lower[joint], upper = robot.upper[joint];
      if (within.lowest[joint] >= lower && within.highest[joint] <= upper &&
          within.velocity[joint] <= paced_path.velocity[joint] &&
          within.acceleration[joint] <= paced_path.acceleration[joint] &&
          within.jerk[joint] <= paced_path.jerk[joint]) {
        continue;
      }
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, joint);
      const double beyond = math::limit_excess(piece, lower, upper);
      // the fit keeps half of this inset at best
      const bool fixed = upper - lower < 4 * kLimitInset_rad;
      if (beyond > 0 && !fixed) worst = std::max(worst, slowdown_within_limits(beyond));
      const math::QuinticExtremes over = math::extremes(piece);
      const auto ratio = [](const math::Range& range, double limit) {
        return std::max(-range.least, range.greatest) / limit;
      };
      worst = std::max({worst, ratio(over.velocity, paced_path.velocity[joint]),
                        std::sqrt(ratio(over.acceleration, paced_path.acceleration[joint])),
                        std::cbrt(ratio(over.jerk, paced_path.jerk[joint]))});
    }
    out.push_back(worst);
  }
  return out;
}

/// Slows the path down at samples that exceed the limits, and for a few knots around them.
void slow_down(ConstrainedPath& paced_path, const SampledLaw& sampled,
               const std::vector<double>& hasty) {
  const auto cells = static_cast<Eigen::Index>(paced_path.slowdown.size());
  const auto cell_of = [&](double u) {
    return static_cast<Eigen::Index>(u / paced_path.spline.duration_s * static_cast<double>(cells));
  };
  std::vector<double> factor(paced_path.slowdown.size(), 1);
  for (std::size_t i = 0; i < hasty.size(); ++i) {
    if (hasty[i] <= 1) continue;
    const Eigen::Index from =
        std::max<Eigen::Index>(0, cell_of(sampled.clock[i]) - kSlowdownReachKnots);
    const Eigen::Index to =
        std::min(cells - 1, cell_of(sampled.clock[i + 1]) + kSlowdownReachKnots);
    for (Eigen::Index k = from; k <= to; ++k) {
      double& here = factor[static_cast<std::size_t>(k)];
      here = std::max(here, hasty[i] * (1 + kLimitMarginRatio));
    }
  }
  for (std::size_t k = 0; k < factor.size(); ++k) paced_path.slowdown[k] *= factor[k];
}

/// A law, its samples, and the slowdown that each step between them requires.
struct RetimeAttempt {
  QuantizedLaw paced;
  SampledLaw sampled;
  std::vector<double> required_slowdowns;
  double worst = 0;
};

/// Samples the law, unless it takes longer than an hour, which would need too much memory.
void sample(const ConstrainedPath& paced_path, double rate_hz, RetimeAttempt& attempt) {
  constexpr double kMaxDuration_s = 3600;
  if (static_cast<double>(attempt.paced.periods) > kMaxDuration_s * rate_hz + 2) {
    attempt.worst = std::numeric_limits<double>::infinity();
    return;
  }
  attempt.sampled = sample_law(paced_path, attempt.paced, rate_hz);
  attempt.required_slowdowns = compute_slowdowns(paced_path, attempt.sampled.trajectory);
  attempt.worst =
      *std::max_element(attempt.required_slowdowns.begin(), attempt.required_slowdowns.end());
}

using LawFunction = std::function<std::optional<QuantizedLaw>(ConstrainedPath&)>;

/// Computes and samples laws until the quintics respect the limits, slowing the path down where
/// they do not, and in the last rounds as a whole. Returns false if this does not succeed, or if
/// there is no law.
bool retime_within_limits(ConstrainedPath& paced_path, const LawFunction& pace, double rate_hz,
                          RetimeAttempt& attempt) {
  for (int round = 0; round <= kMaxCorrections; ++round) {
    std::optional<QuantizedLaw> paced = pace(paced_path);
    if (!paced) return false;
    attempt.paced = std::move(*paced);
    sample(paced_path, rate_hz, attempt);
    if (attempt.worst <= 1) return true;
    if (!std::isfinite(attempt.worst)) return false;
    // The last rounds slow down the whole path.
    std::vector<double> hasty = attempt.required_slowdowns;
    if (2 * round >= kMaxCorrections) std::fill(hasty.begin(), hasty.end(), attempt.worst);
    slow_down(paced_path, attempt.sampled, hasty);
  }
  return false;
}

/// Computes a law with as many periods as necessary.
bool retime_stretching(ConstrainedPath& paced_path, const LawFunction& pace, double rate_hz,
                       RetimeAttempt& attempt) {
  if (retime_within_limits(paced_path, pace, rate_hz, attempt)) return true;
  if (!std::isfinite(attempt.worst)) return false;
  for (int stretch = 0; attempt.worst > 1 && stretch < kMaxCorrections; ++stretch) {
    const auto moving = static_cast<double>(attempt.paced.periods - 2);
    const double longer =
        std::min(kMaxPeriodCount, std::ceil(moving * attempt.worst * (1 + kLimitMarginRatio)));
    attempt.paced.periods = 2 + static_cast<Eigen::Index>(longer);
    sample(paced_path, rate_hz, attempt);
  }
  return attempt.worst <= 1;
}

/// Computes a law with a given number of periods: in the human's proportions; without the pauses,
/// which may leave too little time for the motion; or as the fastest motion, stretched. Stretching
/// respects the limits except for the effect of different sampling instants; if they are exceeded,
/// the fastest motion is used unchanged, with rest at the end.
bool retime_to_duration(Eigen::Index periods,
                        const std::function<ConstrainedPath(bool keep_pauses)>& make,
                        double rate_hz, RetimeAttempt& attempt) {
  const auto pace = [&](ConstrainedPath& c) { return duration_mode_law(c, rate_hz, periods); };
  ConstrainedPath paced_path = make(true);
  const double with_pauses_s = paced_path.spline.duration_s;
  if (retime_within_limits(paced_path, pace, rate_hz, attempt)) return true;
  const ConstrainedPath without = make(false);
  paced_path = without;
  const bool pauses = paced_path.spline.duration_s < with_pauses_s;
  if (pauses && retime_within_limits(paced_path, pace, rate_hz, attempt)) return true;
  paced_path = without;
  const auto fastest = [&](ConstrainedPath& c) { return fastest_mode_law(c, rate_hz); };
  if (!retime_stretching(paced_path, fastest, rate_hz, attempt)) return false;
  const Eigen::Index least = attempt.paced.periods;
  if (least > periods) return false;
  attempt.paced.periods = periods;
  sample(paced_path, rate_hz, attempt);
  if (attempt.worst <= 1) return true;
  attempt.paced.periods = least;
  attempt.paced.rest = periods - least;
  sample(paced_path, rate_hz, attempt);
  return attempt.worst <= 1;
}

}  // namespace

std::string validation_error(const PhaseSpeed& o) {
  if (!(o.scale >= 1e-3)) return "scale must be at least 0.001";
  return "";
}

std::string validation_error(const RetimeOptions& o) {
  if ((o.mode == RetimeMode::duration) != o.duration_s.has_value()) {
    return "duration_s must be given with mode duration, and only with it";
  }
  if (o.duration_s && !(*o.duration_s > 0 && *o.duration_s <= 3600)) {
    return "duration_s must be above 0 and at most 3600";
  }
  if (!(o.sample_rate_hz >= 10 && o.sample_rate_hz <= 10000)) {
    return "sample_rate_hz must be 10 to 10000";
  }
  if (!(o.limit_scaling >= 1e-3 && o.limit_scaling <= 1))
    return "limit_scaling must lie in [0.001, 1]";
  if (o.max_tip_speed && !(*o.max_tip_speed >= 1e-3)) return "max_tip_speed must be at least 0.001";
  if (!(o.smoothing_s >= 0)) return "smoothing_s must not be negative";
  if (!(o.tip_tolerance >= 0)) return "tip_tolerance must not be negative";
  if (!(o.joint_tolerance >= 0)) return "joint_tolerance must not be negative";
  if (!(o.planned_smoothing_factor > 0)) return "planned_smoothing_factor must be positive";
  return "";
}

Outcome<RetimeResult> retime(const RobotModel& robot, const JointPath& path,
                             const Movement& movement, const RetimeOptions& options) {
  if (std::string wrong = path_error(robot, path); !wrong.empty()) {
    return {{}, {Reason::invalid_path, std::move(wrong)}};
  }
  if (std::string beyond = limit_violation(robot, path); !beyond.empty()) {
    return {{}, {Reason::joint_limit, std::move(beyond)}};
  }
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
    ConstrainedPath paced_path = make(human || catch_up);
    const auto pace = [&](ConstrainedPath& c) {
      return catch_up ? catch_up_mode_law(c, rate_hz)
             : human  ? human_mode_law(c, rate_hz)
                      : fastest_mode_law(c, rate_hz);
    };
    if (!retime_stretching(paced_path, pace, rate_hz, attempt)) {
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
