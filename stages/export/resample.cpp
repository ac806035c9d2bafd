#include "stages/export/resample.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/math/quintic.hpp"

namespace morphe::exports {
namespace {

/// Share of a step: a point closer to the end of the trajectory than this is left out.
constexpr double kEndToleranceShare = 1e-6;
/// Tolerances of the junction of two planned motions in position, velocity and acceleration.
constexpr std::array<double, 3> kContinuityTolerance = {1e-6, 1e-5, 1e-3};

constexpr std::array<JointRows Trajectory::*, 3> kDerivativeRows = {
    &Trajectory::position, &Trajectory::velocity, &Trajectory::acceleration};

std::vector<double> sample_times(double end_s, double rate_hz) {
  std::vector<double> time;
  for (std::size_t k = 0;; ++k) {
    const double t = static_cast<double>(k) / rate_hz;
    if (k > 0 && (end_s - t) * rate_hz < kEndToleranceShare) break;
    time.push_back(t);
  }
  time.push_back(end_s);
  return time;
}

Trajectory make_trajectory(std::size_t samples, Eigen::Index joints) {
  Trajectory t;
  for (const auto rows : kDerivativeRows) (t.*rows).resize(samples, joints);
  return t;
}

/// Appends the values of one sample except the joint rows.
void add_labels(const Trajectory& from, Eigen::Index sample, Trajectory& to) {
  to.demonstration_time.push_back(from.demonstration_time[sample]);
  to.phase.push_back(from.phase[sample]);
  to.origin.push_back(from.origin[sample]);
  to.clearance.push_back(from.clearance[sample]);
}

math::JointState state_of(const Trajectory& t, Eigen::Index sample, Eigen::Index joint) {
  return {t.position(sample, joint), t.velocity(sample, joint), t.acceleration(sample, joint)};
}

math::JointState difference(const math::JointState& a, const math::JointState& b) {
  return {a.position - b.position, a.velocity - b.velocity, a.acceleration - b.acceleration};
}

Eigen::Index last_of(const Trajectory& t) { return t.position.rows() - 1; }

/// Moves the begin of a motion exactly to the end of another one, or its end to the begin of that,
/// by adding a quintic over the whole duration. The sum of two quintics is a quintic: the motion
/// remains piecewise quintic.
Trajectory shift_endpoint(Trajectory t, bool begin, const Trajectory& to) {
  const double duration = t.time.back() - t.time[0];
  for (Eigen::Index joint = 0; joint < t.position.cols(); ++joint) {
    const math::JointState gap =
        begin ? difference(state_of(to, last_of(to), joint), state_of(t, 0, joint))
              : difference(state_of(to, 0, joint), state_of(t, last_of(t), joint));
    const math::QuinticPiece shift =
        begin ? math::quintic_piece(gap, {}, duration) : math::quintic_piece({}, gap, duration);
    for (int i = 0; i < std::ssize(t.time); ++i) {
      for (int order = 0; order < std::ssize(kDerivativeRows); ++order) {
        (t.*kDerivativeRows[order])(i, joint) +=
            math::value_at(shift, t.time[i] - t.time[0], order);
      }
    }
  }
  return t;
}

/// A point of the quintic that follows a sample.
struct CurvePoint {
  double time_s = 0;        ///< that it gets
  Eigen::Index sample = 0;  ///< before it
  double elapsed_s = 0;     ///< since that sample, which it is if this is 0
};

Trajectory points_of(const Trajectory& from, const std::vector<CurvePoint>& points) {
  Trajectory to = make_trajectory(points.size(), from.position.cols());
  for (int k = 0; k < std::ssize(points); ++k) {
    const auto& [time_s, sample, elapsed_s] = points[k];
    to.time.push_back(time_s);
    add_labels(from, sample, to);
    for (Eigen::Index joint = 0; joint < to.position.cols(); ++joint) {
      for (int order = 0; order < std::ssize(kDerivativeRows); ++order) {
        const auto rows = kDerivativeRows[order];
        (to.*rows)(k, joint) =
            elapsed_s == 0
                ? (from.*rows)(sample, joint)
                : math::value_at(math::quintic_piece(from, sample, joint), elapsed_s, order);
      }
    }
    if (elapsed_s == 0) continue;
    const double share = elapsed_s / (from.time[sample + 1] - from.time[sample]);
    to.demonstration_time.back() =
        std::lerp(from.demonstration_time[sample], from.demonstration_time[sample + 1], share);
  }
  return to;
}

/// Returns the points at these times since the begin; the last one is the end of the trajectory.
std::vector<CurvePoint> curve_points(const Trajectory& from, const std::vector<double>& time) {
  const Eigen::Index end = last_of(from);
  std::vector<CurvePoint> points;
  Eigen::Index sample = 0;
  for (const double time_s : time) {
    const double t = from.time[0] + time_s;
    while (sample + 1 < end && from.time[sample + 1] <= t) ++sample;
    points.push_back({time_s, sample, t - from.time[sample]});
  }
  points.back() = {points.back().time_s, end, 0};
  return points;
}

double duration(const Trajectory& t) { return t.time.back() - t.time[0]; }

}  // namespace

Trajectory adjust_end(const Trajectory& motion, const Trajectory& next) {
  return shift_endpoint(motion, false, next);
}

Trajectory adjust_begin(const Trajectory& motion, const Trajectory& before) {
  return shift_endpoint(motion, true, before);
}

Trajectory resample(const Trajectory& from, double rate_hz) {
  return points_of(from, curve_points(from, sample_times(duration(from), rate_hz)));
}

Trajectory resample_uniformly(const Trajectory& from, double rate_hz) {
  std::vector<double> time = sample_times(duration(from), rate_hz);
  time.back() = static_cast<double>(time.size() - 1) / rate_hz;
  Trajectory to = points_of(from, curve_points(from, time));
  to.velocity.bottomRows(1).setZero();
  to.acceleration.bottomRows(1).setZero();
  return to;
}

Trajectory subdivide(const Trajectory& from, int parts) {
  if (parts < 2) return from;
  std::vector<CurvePoint> points;
  for (int i = 0; i + 1 < std::ssize(from.time); ++i) {
    const double step_s = from.time[i + 1] - from.time[i];
    for (int part = 0; part < parts; ++part)
      points.push_back({from.time[i] + step_s * part / parts, i, step_s * part / parts});
  }
  points.push_back({from.time.back(), last_of(from), 0});
  return points_of(from, points);
}

Trajectory add_initial_wait(const Trajectory& from, double delay_s) {
  if (!(delay_s > 0)) return from;
  Trajectory to = make_trajectory(from.samples() + 1, from.position.cols());
  to.time.push_back(0);
  add_labels(from, 0, to);
  for (const auto rows : kDerivativeRows) {
    (to.*rows).row(0).setZero();
    (to.*rows).bottomRows((from.*rows).rows()) = from.*rows;
  }
  to.position.row(0) = from.position.row(0);
  for (int i = 0; i < std::ssize(from.time); ++i) {
    to.time.push_back(delay_s + (from.time[i] - from.time[0]));
    add_labels(from, i, to);
  }
  return to;
}

std::string initial_motion_error(const RobotModel& robot, const Trajectory& trajectory) {
  Trajectory rest = make_trajectory(1, trajectory.position.cols());
  for (const auto rows : kDerivativeRows) (rest.*rows).setZero();
  rest.position.row(0) = trajectory.position.row(0);
  return continuity_error(robot, rest, trajectory);
}

std::string continuity_error(const RobotModel& robot, const Trajectory& first,
                             const Trajectory& second) {
  constexpr std::array<const char*, 3> kQuantities = {"position", "velocity", "acceleration"};
  for (int order = 0; order < std::ssize(kDerivativeRows); ++order) {
    const JointRows& before = first.*kDerivativeRows[order];
    const JointRows& after = second.*kDerivativeRows[order];
    Eigen::Index joint = 0;
    const double step = (after.row(0) - before.row(before.rows() - 1)).cwiseAbs().maxCoeff(&joint);
    if (step <= kContinuityTolerance[order]) continue;
    return fmt::format("the {} of {} jumps by {:.2g}", kQuantities[order], robot.joint_names[joint],
                       step);
  }
  return "";
}

Trajectory concatenate(const Trajectory& first, const Trajectory& second) {
  const Eigen::Index before = last_of(first);
  Trajectory both = make_trajectory(before + second.position.rows(), first.position.cols());
  for (const auto rows : kDerivativeRows) {
    const JointRows& after = second.*rows;
    (both.*rows).topRows(before) = (first.*rows).topRows(before);
    (both.*rows).bottomRows(after.rows()) = after;
  }
  for (int i = 0; i < before; ++i) {
    both.time.push_back(first.time[i]);
    add_labels(first, i, both);
  }
  for (int i = 0; i < std::ssize(second.time); ++i) {
    both.time.push_back(first.time.back() + (second.time[i] - second.time[0]));
    add_labels(second, i, both);
  }
  return both;
}

}  // namespace morphe::exports
