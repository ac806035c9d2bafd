#pragma once

#include <cstddef>
#include <vector>

namespace morphe::reconstruct {

/// One quantity as two devices saw it, sampled at the same rate from the same instant by their own
/// clocks; NaN = not seen.
struct SeenTwice {
  std::vector<double> reference, other;  ///< equally long
};

/// What the correlation of two devices says about their clocks.
struct ClockOffset {
  double late_s = 0;       ///< the other clock shows this much more at the same instant
  double sure_s = 0;       ///< standard deviation of late_s
  double correlation = 0;  ///< at the best shift
  double moved = 0;        ///< RMS of the signals' rates, of the device that saw less [unit/s]
};

/// Shift t that maximises the correlation coefficient of the rates of change of reference(x) and
/// other(x + t), summed over the signals, |t| <= 0.5 s, between the samples by the parabola through
/// the best and its two neighbours; 0 if nothing moves or the best shift is the last one. Rates,
/// because what drifts slowly tells nothing. The deviation follows from the peak's curvature c:
/// sqrt((1 - r^2) / (c n)), n the independent samples, 2 cutoff_hz a second and signal.
ClockOffset clock_offset(const std::vector<SeenTwice>& signals, double rate_hz, double cutoff_hz);

/// Whether it is to be believed: a correlation above 0.6, which noise does not reach, and a
/// deviation below 20 ms.
bool clear(const ClockOffset& offset);

}  // namespace morphe::reconstruct
