#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::retime {

/// The path parameter u = g(w) as a function of a parameter w. On a ramp at the beginning, g' rises
/// from 0 to 1 as 6z^2 - 8z^3 + 3z^4, z = w / ramp; the ramp at the end is symmetric. At both ends
/// dq/dw and d2q/dw2 vanish. Any smooth dw/dt thus starts and ends with zero velocity and
/// acceleration, and dw/dt is finite there if the jerk is bounded.
struct RampedParameter {
  double ramp = 0;    ///< [s]
  double length = 0;  ///< length of w; that of the path parameter is length - 0.8 ramp [s]
};
/// Returns the ramped parameter for a path parameter of the length `clock_length`; shortens ramps
/// that are too long for it.
RampedParameter ramp_ends(double clock_length, double ramp_s);

/// g and its first three derivatives at some w.
struct ParameterDerivatives {
  double u = 0, d1 = 0, d2 = 0, d3 = 0;
};
/// Evaluates g and its derivatives at w.
ParameterDerivatives clock_at(const RampedParameter& clock, double w);

/// Converts derivatives with respect to u, rows 0 … 3 of q [4, n], to those with respect to w.
void apply_chain_rule(const ParameterDerivatives& g, JointRows& q);

/// x = (dw/dt)^2 along w as a uniform cubic B-spline, C^2, so that the jerk is continuous.
struct SquaredVelocity {
  double length = 1;            ///< length of w
  Eigen::VectorXd coefficient;  ///< [intervals + 3]
};
/// Evaluates x at w.
double squared_velocity_at(const SquaredVelocity& progress, double w);

/// The squared velocity profile, as a function of time.
struct SplineLaw {
  RampedParameter clock;
  SquaredVelocity square;
  double cell = 1;           ///< cell length in w, a part of a knot interval
  std::vector<double> time;  ///< at the edges of the cells, from 0 [s]
};
/// Integrates the time along a squared velocity profile.
SplineLaw spline_law(const RampedParameter& clock, SquaredVelocity progress);
/// Returns u at a time, clamped to the ends.
double clock_at(const SplineLaw& law, double time_s);

}  // namespace morphe::retime
