#pragma once

#include "stages/retime/constrained_path.hpp"
#include "stages/retime/squared_velocity.hpp"

namespace morphe::retime {

/// Minimises the duration, integral of x^(-1/2) dw, subject to
///   |q_ww x + q_w x_w / 2| <= a,  |q_www x + 3/2 q_ww x_w + q_w x_ww / 2| x^(1/2) <= j
/// and u_w x^(1/2) at most the path's velocity limit (x^(1/2) at most `most`), at the knots and
/// between them; the values in between may exceed the bounds slightly. A log-barrier method with
/// Newton steps on the banded system, from a slow feasible start; every iterate is feasible.
/// `scale_s` is an estimate of the duration. If the resulting spline is not positive between its
/// knots, the start is returned.
SquaredVelocity fastest_squared_velocity(const ConstrainedPath& paced_path,
                                         const RampedParameter& clock, Eigen::Index intervals,
                                         double most, double scale_s);

}  // namespace morphe::retime
