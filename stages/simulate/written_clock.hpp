#pragma once

namespace morphe::simulate {

/// A moment of a trajectory's clock: time since its start, and the derivatives of this time with
/// respect to the time of the simulation.
struct ClockReading {
  double time_s = 0, rate = 0, rate_slope = 0;
};

/// The clock of a written trajectory, which runs from one moment of it to another at its written
/// rate. If it starts from rest, or comes to rest, its rate changes between 0 and 1 along
/// minimum_jerk() while the trajectory advances by half the duration of the ramp.
class WrittenClock {
 public:
  /// The ramps last kClockRamp_s, or less if the interval is shorter than they need.
  WrittenClock(double from_s, double to_s, bool starts_from_rest, bool comes_to_rest);

  /// Returns the time that the clock needs [s].
  double duration_s() const;
  /// Returns the clock at a time since it was started, at most its duration.
  ClockReading at(double elapsed_s) const;

 private:
  double from_s_, to_s_, start_ramp_s_, stop_ramp_s_;
};

}  // namespace morphe::simulate
