#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::retime {

/// The clock over a parameter w that is slow at its ends: u = g(w) with g' = 6z^2 - 8z^3 + 3z^4,
/// z = w / ramp, rising from 0 to 1 (the same backwards at the end). dq/dw and d2q/dw2 vanish
/// there, so that any smooth dw/dt starts and ends at rest in velocity and acceleration; with a
/// bounded jerk dw/dt is finite there.
struct RampedClock {
  double ramp = 0;    ///< [s]
  double length = 0;  ///< of w; the clock's is length - 0.8 ramp [s]
};
RampedClock ramp_ends(double clock_length, double ramp_s);

/// g and its first three derivatives.
struct ClockAt {
  double u = 0, d1 = 0, d2 = 0, d3 = 0;
};
ClockAt clock_at(const RampedClock& clock, double w);

/// Derivatives by the clock, rows 0 … 3 of q [4, n], become derivatives by w.
void chain(const ClockAt& at, JointRows& q);

}  // namespace morphe::retime
