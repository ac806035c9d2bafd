#pragma once

#include <vector>

#include "stages/retime/course.hpp"
#include "stages/retime/ramped_clock.hpp"

namespace morphe {

/// Progress along w: x = (dw/dt)^2 as a cubic B-spline on uniform knots, C^2, so that the jerk is
/// continuous.
struct Progress {
  double length = 1;            ///< of w
  Eigen::VectorXd coefficient;  ///< [intervals + 3]
};
double square_at(const Progress& progress, double w);

/// Minimises the duration, integral of x^(-1/2) dw, subject to
///   |q_ww x + q_w x_w / 2| <= a,  |q_www x + 3/2 q_ww x_w + q_w x_ww / 2| x^(1/2) <= j
/// and u_w x^(1/2) at most the course's pace (x^(1/2) at most `most`), all at the knots and between
/// them; what lies in between may exceed them a little. Log barrier, Newton on the banded system,
/// from a slow progress that is feasible, as is every iterate. `scale_s`: about how long it will
/// take. If the spline is not positive between its knots, the start is what is left.
Progress fastest_progress(const Course& course, const RampedClock& clock, Eigen::Index intervals,
                          double most, double scale_s);

/// The progress as motion over time.
struct ProgressLaw {
  RampedClock clock;
  Progress progress;
  double cell = 1;           ///< of w, a part of a knot interval
  std::vector<double> time;  ///< at the edges of the cells, from 0 [s]
};
ProgressLaw progress_law(const RampedClock& clock, Progress progress);
/// u at a time; the ends beyond them.
double clock_at(const ProgressLaw& law, double time_s);

}  // namespace morphe
