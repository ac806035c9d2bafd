#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::retime {

/// A scale of the speed in one phase.
struct PhaseSpeed {
  PhaseKind phase = PhaseKind::rest;
  double scale = 1;
};
template <class Fields>
void fields(Fields& f, PhaseSpeed& o) {
  f.required("phase", o.phase);
  f.required("scale", o.scale, bounds::kFactor);
}

/// The goal of the time parametrisation, as retime() explains it.
enum class RetimeMode { human, fastest, duration, catch_up };
constexpr std::array<std::string_view, 4> names_of(RetimeMode) {
  return {"human", "fastest", "duration", "catch_up"};
}

/// The options of the time parametrisation.
struct RetimeOptions {
  RetimeMode mode = RetimeMode::human;
  std::optional<double> duration_s;  ///< total duration in mode duration [s]
  double sample_rate_hz = 500;       ///< rate of the controller
  double limit_scaling = 1;  ///< permitted share of the velocity, acceleration and jerk limits
  std::optional<double> max_tip_speed;  ///< [m/s]
  std::vector<PhaseSpeed> phase_speed;  ///< factors on nominal, joint and tip speed during phases
  double smoothing_s = 0.02;  ///< features of the path shorter than about this are smoothed [s] …
  double tip_tolerance = 2e-4;  ///< … unless a tip moves by more than this [m]; 0 means 1e-5 …
  double joint_tolerance = 1e-3;  ///< … or a joint that moves no tip by more [rad]; 0 means 1e-5
  double planned_smoothing_factor = 4;  ///< factor of duration and tolerances for planned intervals
};
template <class Fields>
void fields(Fields& f, RetimeOptions& o) {
  f("mode", o.mode);
  f("duration_s", o.duration_s, bounds::kPositiveDuration);
  f("sample_rate_hz", o.sample_rate_hz, bounds::kRate.from(10));
  f("limit_scaling", o.limit_scaling, bounds::kShare.from(1e-3));
  f("max_tip_speed", o.max_tip_speed, bounds::kSpeed);
  f("phase_speed", o.phase_speed);
  f("smoothing_s", o.smoothing_s, bounds::kSmoothing);
  f("tip_tolerance", o.tip_tolerance, bounds::kLength);
  f("joint_tolerance", o.joint_tolerance, bounds::kAngleSize);
  f("planned_smoothing_factor", o.planned_smoothing_factor, bounds::kFactor);
}
/// Returns an error sentence, or "" if the options are valid.
std::string validation_error(const RetimeOptions& options);

/// The result of the time parametrisation.
struct RetimeResult {
  Trajectory trajectory;                          ///< its clearance is NaN until it is certified
  double tip_deviation = 0, joint_deviation = 0;  ///< largest over the path's samples [m], [rad]
};

/// Computes the time parametrisation of a path. q(u) is a C^4 spline through its samples (within
/// the tolerances); u(t) is such that the velocity, acceleration and jerk limits hold, of which
/// infinite ones do not bind. The mode determines the timing:
///   human     the demonstration's timing wherever the limits allow it, slower elsewhere;
///   fastest   the fastest motion within the limits;
///   duration  takes duration_s, in the human's proportions as far as the limits allow; any
///             duration that is not shorter than the fastest is met;
///   catch_up  like human, but delays caused by the limits are recovered afterwards, at up to 1.4
///             times the demonstration's speed, until the timing is the demonstration's again.
/// The motion starts and ends with velocity and acceleration exactly zero. The limits hold for the
/// quintics between the samples, not only at the samples. Fails with invalid_path (not a path of
/// this robot), joint_limit or duration_too_short.
Outcome<RetimeResult> retime(const RobotModel& robot, const JointPath& path,
                             const Movement& movement, const RetimeOptions& options);

}  // namespace morphe::retime
