#pragma once

#include <vector>

namespace morphe::reconstruct {

/// Samples of one quantity by two devices, at equal times of their own clocks; NaN if unseen.
struct PairedSignal {
  std::vector<double> reference, other;  ///< samples of the two devices, equally many
};

/// The offset between the clocks of two devices, estimated by correlation.
struct ClockOffset {
  double offset_s = 0;     ///< other clock less reference clock at the same instant
  double offset_sd_s = 0;  ///< standard deviation of offset_s
  double correlation = 0;  ///< correlation coefficient at the best shift
  double rate_rms = 0;     ///< RMS rate of change, of the device with the smaller one [unit/s]
};

/// Estimates the shift t, |t| <= 0.5 s, that maximises the correlation coefficient of the rates of
/// change of reference(x) and other(x + t), summed over the signals; drifts are slow and hardly
/// count. The parabola through the best shift and its two neighbours refines it. If the signals are
/// constant or the best shift is the first or last, offset_s is 0 and offset_sd_s 0.5 s. Signals
/// are sampled at `rate_hz` and low-passed at `cutoff_hz`. The standard deviation follows from the
/// peak's curvature c and the number n of independent samples, 2 cutoff_hz per second and signal:
///   sqrt((1 - r²) / (c n)).
ClockOffset clock_offset(const std::vector<PairedSignal>& signals, double rate_hz,
                         double cutoff_hz);

/// Returns true if the correlation is above 0.6, which noise does not reach, and the standard
/// deviation below 20 ms.
bool is_reliable(const ClockOffset& offset);

}  // namespace morphe::reconstruct
