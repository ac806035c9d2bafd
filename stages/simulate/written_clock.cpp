#include "stages/simulate/written_clock.hpp"

#include <algorithm>

#include "stages/simulate/options.hpp"
#include "stages/simulate/plan_lift.hpp"

namespace morphe::simulate {
namespace {

/// Returns the integral of minimum_jerk() from 0 to s; it is 0.5 at 1.
double minimum_jerk_integral(double s) { return s * s * s * s * (2.5 - 3 * s + s * s); }

double minimum_jerk_slope(double s) { return 30 * s * s * (1 - s) * (1 - s); }

}  // namespace

WrittenClock::WrittenClock(double from_s, double to_s, bool starts_from_rest, bool comes_to_rest)
    : from_s_(from_s), to_s_(std::max(from_s, to_s)) {
  const double ramps = (starts_from_rest ? 0.5 : 0) + (comes_to_rest ? 0.5 : 0);
  const double ramp_s = ramps > 0 ? std::min(kClockRamp_s, (to_s_ - from_s_) / ramps) : 0;
  start_ramp_s_ = starts_from_rest ? ramp_s : 0;
  stop_ramp_s_ = comes_to_rest ? ramp_s : 0;
}

double WrittenClock::duration_s() const {
  return to_s_ - from_s_ + 0.5 * (start_ramp_s_ + stop_ramp_s_);
}

ClockReading WrittenClock::at(double elapsed_s) const {
  const double remaining_s = duration_s() - elapsed_s;
  if (elapsed_s < start_ramp_s_) {
    const double s = elapsed_s / start_ramp_s_;
    return {from_s_ + start_ramp_s_ * minimum_jerk_integral(s), minimum_jerk(s),
            minimum_jerk_slope(s) / start_ramp_s_};
  }
  if (remaining_s < stop_ramp_s_) {
    const double s = std::max(0.0, remaining_s / stop_ramp_s_);
    return {to_s_ - stop_ramp_s_ * minimum_jerk_integral(s), minimum_jerk(s),
            -minimum_jerk_slope(s) / stop_ramp_s_};
  }
  return {std::min(to_s_, from_s_ + elapsed_s - 0.5 * start_ramp_s_), 1, 0};
}

}  // namespace morphe::simulate
