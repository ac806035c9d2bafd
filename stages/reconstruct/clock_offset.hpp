#pragma once

#include <cstddef>
#include <vector>

namespace morphe {

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
  double moved = 0;  ///< least RMS of the two devices' signals about their means, over them all
};

/// Shift t that maximises the correlation coefficient of reference(x) and other(x + t), summed over
/// the signals, |t| <= 0.5 s, between the samples by the parabola through the best and its two
/// neighbours; 0 if nothing moves or the best shift is the last one. The deviation follows from the
/// peak's curvature c: sqrt((1 - r^2) / (c n)), n the independent samples, 2 cutoff_hz a second.
ClockOffset clock_offset(const std::vector<SeenTwice>& signals, double rate_hz, double cutoff_hz);

/// Whether it is to be believed: a clear correlation (0.8), a movement (RMS 0.03), and a deviation
/// below 15 ms.
bool clear(const ClockOffset& offset);

}  // namespace morphe
