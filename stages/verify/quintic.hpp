#pragma once

#include <array>

namespace morphe::verify {

/// One joint between two samples: q(s) = sum_k c_k s^k, s in [0, 1], the quintic that meets
/// position, velocity and acceleration at both ends [rad].
struct Quintic {
  std::array<double, 6> c{};
  double step_s = 1;
};

struct JointState {
  double position = 0, velocity = 0, acceleration = 0;
};
Quintic quintic_between(double step_s, const JointState& from, const JointState& to);

/// The order-th derivative to time at s, order 0 … 3 [rad/s^order].
double derivative(const Quintic& quintic, int order, double s);

struct Extreme {
  double s = 0, value = 0;
};
struct Range {
  Extreme least, greatest;
};

/// Exact ranges over s in [0, 1] of position, velocity, acceleration and jerk. The zeros of each
/// derivative are where the one below turns, so a chain from the linear snap down finds them all.
std::array<Range, 4> ranges(const Quintic& quintic);
/// Over s in [from, to] alone.
std::array<Range, 4> ranges(const Quintic& quintic, double from, double to);

}  // namespace morphe::verify
