#pragma once

#include <vector>

#include "stages/retime/ramped_parameter.hpp"

namespace morphe::retime {

/// The squared velocity along w, x = (dw/dt)^2, as a cubic B-spline on uniform knots, C^2, so that
/// the jerk is continuous.
struct SquaredVelocity {
  double length = 1;            ///< length of w
  Eigen::VectorXd coefficient;  ///< [intervals + 3]
};
/// Evaluates x at w.
double squared_velocity_at(const SquaredVelocity& progress, double w);

/// The squared velocity profile, as a function of time.
struct SplineLaw {
  RampedParameter clock;
  SquaredVelocity squared_velocity;
  double cell = 1;           ///< cell length in w, a part of a knot interval
  std::vector<double> time;  ///< at the edges of the cells, from 0 [s]
};
/// Integrates the time along a squared velocity profile.
SplineLaw spline_law(const RampedParameter& clock, SquaredVelocity progress);
/// Returns u at a time, clamped to the ends.
double clock_at(const SplineLaw& law, double time_s);

}  // namespace morphe::retime
