#pragma once

#include "stages/retime/paced_path.hpp"
#include "stages/retime/progress.hpp"

namespace morphe::retime {

/// Minimises the duration, integral of x^(-1/2) dw, subject to
///   |q_ww x + q_w x_w / 2| <= a,  |q_www x + 3/2 q_ww x_w + q_w x_ww / 2| x^(1/2) <= j
/// and u_w x^(1/2) at most the path's pace (x^(1/2) at most `most`), all at the knots and between
/// them; what lies in between may exceed them a little. Log barrier, Newton on the banded system,
/// from a slow progress that is feasible, as is every iterate. `scale_s`: about how long it will
/// take. If the spline is not positive between its knots, the start is what is left.
Progress fastest_progress(const PacedPath& paced_path, const RampedClock& clock,
                          Eigen::Index intervals, double most, double scale_s);

}  // namespace morphe::retime
