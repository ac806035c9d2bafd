#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::retime {

struct PhaseSpeed {
  PhaseKind phase = PhaseKind::rest;
  double scale = 1;
};
template <class Fields>
void fields(Fields& f, PhaseSpeed& o) {
  f.required("phase", o.phase);
  f.required("scale", o.scale);
}
std::string why_invalid(const PhaseSpeed& options);

/// The human's wherever the limits allow it, as fast as they allow, taking a given time, or the
/// human's with what was lost made up for.
enum class Tempo { human, fastest, duration, kept };
constexpr std::array<std::string_view, 4> names_of(Tempo) {
  return {"human", "fastest", "duration", "kept"};
}

struct RetimeOptions {
  Tempo mode = Tempo::human;
  std::optional<double> duration_s;     ///< mode duration: what it shall take
  double sample_rate_hz = 500;          ///< of the controller
  double limit_share = 1;               ///< of velocity, acceleration and jerk that may be used
  std::optional<double> tip_speed;      ///< of any tip at most [m/s]
  std::vector<PhaseSpeed> phase_speed;  ///< scales tempo, joint and tip speed in a phase
  double smoothing_s = 0.02;      ///< features of the path shorter than about this are smoothed …
  double tip_tolerance = 2e-4;    ///< … as far as no tip moves by more [m]; 0: 1e-5 …
  double joint_tolerance = 1e-3;  ///< … nor a joint that moves no tip [rad]; 0: 1e-5
  double planned_smoothing = 4;   ///< planned stretches: this many times duration and tolerances
};
template <class Fields>
void fields(Fields& f, RetimeOptions& o) {
  f("mode", o.mode);
  f("duration_s", o.duration_s);
  f("sample_rate_hz", o.sample_rate_hz);
  f("limit_share", o.limit_share);
  f("tip_speed", o.tip_speed);
  f("phase_speed", o.phase_speed);
  f("smoothing_s", o.smoothing_s);
  f("tip_tolerance", o.tip_tolerance);
  f("joint_tolerance", o.joint_tolerance);
  f("planned_smoothing", o.planned_smoothing);
}
std::string why_invalid(const RetimeOptions& options);

struct RetimeResult {
  Trajectory trajectory;                          ///< clearance is NaN until it is certified
  double tip_deviation = 0, joint_deviation = 0;  ///< largest over the path's samples [m], [rad]
};

/// A time law for a path: q(u) a C^4 spline through its samples (within the tolerances), u(t)
/// within velocity, acceleration and jerk limits (an infinite one is none),
///   human     at the demonstration's tempo wherever they allow it, slower elsewhere;
///   fastest   as fast as they allow;
///   duration  taking duration_s, in the human's proportions as far as they allow; any duration
///             that is not less than the fastest is met;
///   kept      as human, but where the limits made it late it hurries afterwards, by at most 1.4
///             times, until the time base is the demonstration's again.
/// Starts and ends with velocity and acceleration exactly zero. The limits hold for the quintics
/// between the samples, not only at them: where they do not, the law is slowed down until they do.
/// Refused: path (not a path of this robot), limit, duration.
Outcome<RetimeResult> retime(const RobotTable& robot, const JointPath& path,
                             const Movement& movement, const RetimeOptions& options);

}  // namespace morphe::retime
