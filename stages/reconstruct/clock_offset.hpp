#pragma once

#include <cstddef>
#include <vector>

namespace morphe::reconstruct {

/// A quantity measured by two devices, sampled at the same rate from the same instant of their own
/// clocks; NaN if not seen.
struct PairedSignal {
  std::vector<double> reference, other;  ///< samples of the two devices, equally many
};

/// The offset between the clocks of two devices, estimated by correlation.
struct ClockOffset {
  /// Excess of the other clock over the reference clock at the same instant [s].
  double offset_s = 0;
  double offset_sd_s = 0;  ///< standard deviation of offset_s
  double correlation = 0;  ///< correlation coefficient at the best shift
  double rate_rms = 0;  ///< RMS of the signals' rates, of the device with the smaller one [unit/s]
};

/// Estimates the shift t that maximises the correlation coefficient of the rates of change of
/// reference(x) and other(x + t), summed over the signals, with |t| <= 0.5 s. It is refined between
/// the samples by the parabola through the best shift and its two neighbours; 0 if the signals are
/// constant or the best shift is the last one. Rates are used because slow drifts carry no
/// information. The standard deviation follows from the peak's curvature c: sqrt((1 - r^2) / (c
/// n)), with n the number of independent samples, 2 cutoff_hz per second and signal.
ClockOffset clock_offset(const std::vector<PairedSignal>& signals, double rate_hz,
                         double cutoff_hz);

/// Returns true if the offset is reliable: a correlation above 0.6, which noise does not reach, and
/// a standard deviation below 20 ms.
bool is_reliable(const ClockOffset& offset);

}  // namespace morphe::reconstruct
