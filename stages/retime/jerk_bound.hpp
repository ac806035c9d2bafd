#pragma once

#include "stages/retime/constrained_path.hpp"
#include "stages/retime/squared_velocity.hpp"

namespace morphe::retime {

/// Returns the x = (dw/dt)^2 that minimises the duration, integral of x^(-1/2) dw, subject to
///   |q_ww x + q_w x_w / 2| <= a,  |q_www x + 3/2 q_ww x_w + q_w x_ww / 2| x^(1/2) <= j,
///   u_w x^(1/2) <= max_path_velocity(),  x^(1/2) <= max_rate
/// at the knots and at points between them; elsewhere the bounds may be exceeded slightly. A
/// log-barrier method takes Newton steps on the banded system; every iterate is feasible. It starts
/// from a slow feasible x, which is returned if the result is not positive between its knots.
/// `scale_s` is an estimate of the duration.
SquaredVelocity fastest_squared_velocity(const ConstrainedPath& path, const RampedParameter& clock,
                                         Eigen::Index intervals, double max_rate, double scale_s);

}  // namespace morphe::retime
