#pragma once

#include <string>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe {

struct RetimeOptions {
  double sample_rate_hz = 500;  ///< of the controller
  double limit_share = 0.99;    ///< share of velocity, acceleration and jerk that may be used
  double tempo_cap = 1;         ///< demonstration seconds per second at most; 1 = the human's tempo
  double smoothing_s = 0.02;    ///< features of the path shorter than about this are smoothed …
  double smoothing_tolerance = 1e-3;  ///< … as far as no sample moves by more [rad]; 0: 1e-5
  double planned_smoothing = 4;       ///< planned stretches: this many times duration and tolerance
};
template <class Fields>
void fields(Fields& f, RetimeOptions& o) {
  f("sample_rate_hz", o.sample_rate_hz);
  f("limit_share", o.limit_share);
  f("tempo_cap", o.tempo_cap);
  f("smoothing_s", o.smoothing_s);
  f("smoothing_tolerance", o.smoothing_tolerance);
  f("planned_smoothing", o.planned_smoothing);
}
std::string check(const RetimeOptions& options);

struct RetimeResult {
  std::string reason;         ///< "" = ok, path (not a path of this robot), limit
  std::string detail;         ///< a sentence
  Trajectory trajectory;      ///< clearance is NaN until it is certified
  double path_deviation = 0;  ///< largest over joints and path samples [rad]
};

/// A time law for a path: q(u) a C^4 spline through (within smoothing_tolerance of) its samples,
/// u(t) the fastest progress that keeps du/dt <= tempo_cap and |v|, |a|, |jerk| <= limit_share of
/// the robot's limits. Starts and ends with velocity and acceleration exactly zero. The limits hold
/// for the quintics between the samples, not only at them: the law is slowed down as a whole until
/// they do.
RetimeResult retime(const RobotTable& robot, const JointPath& path, const Movement& movement,
                    const RetimeOptions& options);

}  // namespace morphe
