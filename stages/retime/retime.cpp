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
#include "stages/retime/inside_limits.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::retime {
namespace {

constexpr double kKnotStep_s = 0.01;  ///< of the path's spline at most
constexpr int kCorrections = 12;      ///< of the law, where the quintics are beyond the limits
constexpr double kInside = 5e-4;      ///< a correction aims this much below them
constexpr Eigen::Index kReach = 4;    ///< knots around an excess that are slowed with it
constexpr std::size_t kPhases = count_of<PhaseKind>();

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
  for (Eigen::Index joint = 0; joint < path.position.cols(); ++joint) {
    const std::string& name = robot.joint_names[static_cast<std::size_t>(joint)];
    if (!(robot.velocity[joint] > 0 && robot.acceleration[joint] > 0 && robot.jerk[joint] > 0)) {
      return fmt::format(
          "joint {} has a limit of velocity, acceleration or jerk that is not above 0", name);
    }
    if (!(robot.lower[joint] <= robot.upper[joint])) {
      return fmt::format("joint {} has no range of positions", name);
    }
    for (Eigen::Index i = 0; i < path.position.rows(); ++i) {
      const double q = path.position(i, joint);
      const double beyond = std::max(robot.lower[joint] - q, q - robot.upper[joint]);
      if (beyond <= kRounding) continue;
      return fmt::format("joint {} is {:.3g} rad beyond its limit at path sample {}", name, beyond,
                         i);
    }
  }
  return "";
}

PacedPath make_paced_path(const RobotTable& robot, const JointPath& path, const Movement& movement,
                          const RetimeOptions& options, bool keep_pauses, RetimeResult& result) {
  PacedPath paced_path;
  paced_path.robot = &robot;
  paced_path.movement = &movement;
  paced_path.clocked = clock_path(robot, path, kKnotStep_s, keep_pauses);
  std::vector<double> allowance;
  for (const Origin origin : paced_path.clocked.origin) {
    allowance.push_back(origin == Origin::planned ? options.planned_smoothing : 1);
  }
  PathFit fitted =
      fit_path(robot, paced_path.clocked.clock, paced_path.clocked.position, allowance,
               {options.smoothing_s, options.tip_tolerance, options.joint_tolerance}, kKnotStep_s);
  paced_path.spline = std::move(fitted.spline);
  result.tip_deviation = fitted.tip_deviation;
  result.joint_deviation = fitted.joint_deviation;
  paced_path.velocity = options.limit_share * robot.velocity;
  paced_path.acceleration = options.limit_share * robot.acceleration;
  paced_path.jerk = options.limit_share * robot.jerk;
  paced_path.braking_share = options.limit_share;
  paced_path.tip_speed = options.tip_speed.value_or(kMostPace);
  if (!options.phase_speed.empty()) paced_path.phase_scale.assign(kPhases, 1);
  for (const PhaseSpeed& phase : options.phase_speed) {
    paced_path.phase_scale[static_cast<std::size_t>(phase.phase)] = phase.scale;
  }
  paced_path.slowdown.assign(static_cast<std::size_t>(paced_path.spline.intervals), 1);
  return paced_path;
}

/// How many times slower a step has to be whose quintic leaves the joint's range so far, where the
/// path does not: what it misses of a smooth path between two samples falls with the sixth power of
/// the time between them. The path keeps half of kLimitInset from its limits.
double slower_inside(double beyond_rad) {
  return std::pow(1 + beyond_rad / (0.5 * kLimitInset), 1.0 / 6);
}

/// How many times slower each step between samples would have to be to hold the path's limits; 0
/// where it surely does.
std::vector<double> haste(const PacedPath& paced_path, const Trajectory& trajectory) {
  const RobotTable& robot = *paced_path.robot;
  std::vector<double> out;
  math::Enclosure within;
  for (std::size_t i = 0; i + 1 < trajectory.samples(); ++i) {
    double worst = 0;
    for (const RobotTable::BrakingCurve& curve : robot.braking_curves) {
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, curve.joint);
      // Below the limit, how far does not matter.
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
      const double beyond = math::beyond(piece, lower, upper);
      const bool fixed = upper - lower < 4 * kLimitInset;  // kept to half of that at best
      if (beyond > 0 && !fixed) worst = std::max(worst, slower_inside(beyond));
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

/// Slows the path where the samples are too hasty, and a few knots around.
void slow_down(PacedPath& paced_path, const SampledLaw& sampled, const std::vector<double>& hasty) {
  const auto cells = static_cast<Eigen::Index>(paced_path.slowdown.size());
  const auto cell_of = [&](double u) {
    return static_cast<Eigen::Index>(u / paced_path.spline.length * static_cast<double>(cells));
  };
  std::vector<double> factor(paced_path.slowdown.size(), 1);
  for (std::size_t i = 0; i < hasty.size(); ++i) {
    if (hasty[i] <= 1) continue;
    const Eigen::Index from = std::max<Eigen::Index>(0, cell_of(sampled.clock[i]) - kReach);
    const Eigen::Index to = std::min(cells - 1, cell_of(sampled.clock[i + 1]) + kReach);
    for (Eigen::Index k = from; k <= to; ++k) {
      double& here = factor[static_cast<std::size_t>(k)];
      here = std::max(here, hasty[i] * (1 + kInside));
    }
  }
  for (std::size_t k = 0; k < factor.size(); ++k) paced_path.slowdown[k] *= factor[k];
}

/// A law, its samples, and how hasty each step between them is.
struct Attempt {
  PacedLaw paced;
  SampledLaw sampled;
  std::vector<double> hasty;
  double worst = 0;
};

/// What takes longer than an hour is no motion: sampled, it would take all memory.
void sample(const PacedPath& paced_path, double rate_hz, Attempt& attempt) {
  constexpr double kLongest_s = 3600;
  if (static_cast<double>(attempt.paced.periods) > kLongest_s * rate_hz + 2) {
    attempt.worst = std::numeric_limits<double>::infinity();
    return;
  }
  attempt.sampled = sample_law(paced_path, attempt.paced, rate_hz);
  attempt.hasty = haste(paced_path, attempt.sampled.trajectory);
  attempt.worst = *std::max_element(attempt.hasty.begin(), attempt.hasty.end());
}

using Pace = std::function<std::optional<PacedLaw>(PacedPath&)>;

/// Paces and samples the path until the quintics hold its limits: slowed down where they do not,
/// and as a whole if that takes too long. False if that never comes, or there is no pace.
bool follow(PacedPath& paced_path, const Pace& pace, double rate_hz, Attempt& attempt) {
  for (int round = 0; round <= kCorrections; ++round) {
    std::optional<PacedLaw> paced = pace(paced_path);
    if (!paced) return false;
    attempt.paced = std::move(*paced);
    sample(paced_path, rate_hz, attempt);
    if (attempt.worst <= 1) return true;
    if (!std::isfinite(attempt.worst)) return false;
    // The last rounds slow down more than where it is needed.
    std::vector<double> hasty = attempt.hasty;
    if (2 * round >= kCorrections) std::fill(hasty.begin(), hasty.end(), attempt.worst);
    slow_down(paced_path, attempt.sampled, hasty);
  }
  return false;
}

/// In as many periods as it takes.
bool follow_freely(PacedPath& paced_path, const Pace& pace, double rate_hz, Attempt& attempt) {
  if (follow(paced_path, pace, rate_hz, attempt)) return true;
  if (!std::isfinite(attempt.worst)) return false;
  for (int stretch = 0; attempt.worst > 1 && stretch < kCorrections; ++stretch) {
    const auto moving = static_cast<double>(attempt.paced.periods - 2);
    const double longer = std::min(kMostPeriods, std::ceil(moving * attempt.worst * (1 + kInside)));
    attempt.paced.periods = 2 + static_cast<Eigen::Index>(longer);
    sample(paced_path, rate_hz, attempt);
  }
  return attempt.worst <= 1;
}

/// In so many periods: in the human's proportions; in those without the pauses, which may leave no
/// time for the way; or as the fastest way there is, stretched. That stays within the limits but
/// for what other instants of sampling do: if it does not, as it is, and at rest thereafter.
bool follow_for(Eigen::Index periods, const std::function<PacedPath(bool keep_pauses)>& make,
                double rate_hz, Attempt& attempt) {
  const auto pace = [&](PacedPath& c) { return pace_duration(c, rate_hz, periods); };
  PacedPath paced_path = make(true);
  const double with_pauses_s = paced_path.spline.length;
  if (follow(paced_path, pace, rate_hz, attempt)) return true;
  const PacedPath without = make(false);
  paced_path = without;
  const bool pauses = paced_path.spline.length < with_pauses_s;
  if (pauses && follow(paced_path, pace, rate_hz, attempt)) return true;
  paced_path = without;
  const auto fastest = [&](PacedPath& c) { return pace_fastest(c, rate_hz); };
  if (!follow_freely(paced_path, fastest, rate_hz, attempt)) return false;
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

std::string why_invalid(const PhaseSpeed& o) {
  if (!(o.scale >= 1e-3)) return "scale must be at least 0.001";
  return "";
}

std::string why_invalid(const RetimeOptions& o) {
  if ((o.mode == Tempo::duration) != o.duration_s.has_value()) {
    return "duration_s belongs to the mode duration, which needs it";
  }
  if (o.duration_s && !(*o.duration_s > 0 && *o.duration_s <= 3600)) {
    return "duration_s must be above 0 and at most 3600";
  }
  if (!(o.sample_rate_hz >= 10 && o.sample_rate_hz <= 10000)) {
    return "sample_rate_hz must be 10 to 10000";
  }
  if (!(o.limit_share >= 1e-3 && o.limit_share <= 1)) return "limit_share must lie in [0.001, 1]";
  if (o.tip_speed && !(*o.tip_speed >= 1e-3)) return "tip_speed must be at least 0.001";
  if (!(o.smoothing_s >= 0)) return "smoothing_s must not be negative";
  if (!(o.tip_tolerance >= 0)) return "tip_tolerance must not be negative";
  if (!(o.joint_tolerance >= 0)) return "joint_tolerance must not be negative";
  if (!(o.planned_smoothing > 0)) return "planned_smoothing must be positive";
  return "";
}

Outcome<RetimeResult> retime(const RobotTable& robot, const JointPath& path,
                             const Movement& movement, const RetimeOptions& options) {
  if (std::string wrong = what_is_wrong(robot, path); !wrong.empty()) {
    return {{}, {Reason::path, std::move(wrong)}};
  }
  if (std::string beyond = what_is_beyond_limits(robot, path); !beyond.empty()) {
    return {{}, {Reason::limit, std::move(beyond)}};
  }
  RetimeResult result;
  const double rate_hz = options.sample_rate_hz;
  const auto make = [&](bool keep_pauses) {
    return make_paced_path(robot, path, movement, options, keep_pauses, result);
  };
  Attempt attempt;
  if (options.mode == Tempo::duration) {
    const double periods = std::floor(*options.duration_s * rate_hz + 1e-9);
    if (!follow_for(static_cast<Eigen::Index>(periods), make, rate_hz, attempt)) {
      return {std::move(result),
              {Reason::duration,
               fmt::format("the path cannot be followed in {} s", *options.duration_s)}};
    }
  } else {
    const bool human = options.mode == Tempo::human, kept = options.mode == Tempo::kept;
    PacedPath paced_path = make(human || kept);
    const auto pace = [&](PacedPath& c) {
      return kept    ? pace_kept(c, rate_hz)
             : human ? pace_human(c, rate_hz)
                     : pace_fastest(c, rate_hz);
    };
    if (!follow_freely(paced_path, pace, rate_hz, attempt)) {
      return {std::move(result),
              {Reason::limit,
               "no slowdown brings the path within the joints' range, velocity, acceleration and "
               "jerk in an hour"}};
    }
  }
  result.trajectory = std::move(attempt.sampled.trajectory);
  return {std::move(result), {}};
}

}  // namespace morphe::retime
