#pragma once

#include <array>

namespace morphe::verify {

/// The trajectory of one joint between two samples: q(s) = sum_k c_k s^k, s in [0, 1], the quintic
/// that interpolates position, velocity and acceleration at both ends [rad; m if prismatic].
struct Quintic {
  std::array<double, 6> c{};
  double step_s = 1;  ///< duration
};

/// The state of one joint at a sample [rad, rad/s, rad/s^2; m if prismatic].
struct JointState {
  double position = 0, velocity = 0, acceleration = 0;
};
/// Returns the quintic that interpolates two states `step_s` apart [s].
Quintic quintic_between(double step_s, const JointState& from, const JointState& to);

/// Returns the order-th time derivative at s, order 0 … 3 [rad/s^order].
double derivative(const Quintic& quintic, int order, double s);

/// An extremum and its location s.
struct Extreme {
  double s = 0, value = 0;
};
/// The least and the greatest value over an interval.
struct Range {
  Extreme least, greatest;
};

/// Computes the exact ranges of position, velocity, acceleration and jerk over s in [0, 1]. The
/// zeros of each derivative are the extrema of the next lower one, from the linear snap downwards.
std::array<Range, 4> ranges(const Quintic& quintic);
/// Computes the ranges over s in [from, to] only.
std::array<Range, 4> ranges(const Quintic& quintic, double from, double to);

}  // namespace morphe::verify
