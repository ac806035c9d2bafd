#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::retime {

/// The path parameter over a parameter w that is slow at its ends: u = g(w) with g' = 6z^2 - 8z^3 +
/// 3z^4, z = w / ramp, rising from 0 to 1 (symmetric at the end). dq/dw and d2q/dw2 vanish there,
/// so that any smooth dw/dt starts and ends with zero velocity and acceleration; with a bounded
/// jerk, dw/dt is finite there.
struct RampedParameter {
  double ramp = 0;    ///< [s]
  double length = 0;  ///< length of w; that of the path parameter is length - 0.8 ramp [s]
};
/// Returns the ramped parameter for a path parameter of that length, with the ramp shortened if
/// necessary.
RampedParameter ramp_ends(double clock_length, double ramp_s);

/// g and its first three derivatives at some w.
struct ParameterDerivatives {
  double u = 0, d1 = 0, d2 = 0, d3 = 0;
};
/// Evaluates g and its derivatives at w.
ParameterDerivatives clock_at(const RampedParameter& clock, double w);

/// Converts derivatives with respect to the path parameter, rows 0 … 3 of q [4, n], to derivatives
/// with respect to w.
void apply_chain_rule(const ParameterDerivatives& at, JointRows& q);

}  // namespace morphe::retime
