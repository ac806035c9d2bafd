#pragma once

#include <vector>

#include "stages/retime/ramped_clock.hpp"

namespace morphe::retime {

/// Progress along w: x = (dw/dt)^2 as a cubic B-spline on uniform knots, C^2, so that the jerk is
/// continuous.
struct Progress {
  double length = 1;            ///< of w
  Eigen::VectorXd coefficient;  ///< [intervals + 3]
};
double square_at(const Progress& progress, double w);

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

}  // namespace morphe::retime
