#pragma once

#include <vector>

namespace morphe::math {

/// Applies a zero-phase low-pass filter: a second-order Butterworth filter run forwards and
/// backwards. Its gain at frequency f is 1 / (1 + (sqrt(2) - 1) (tan(pi f / rate) / tan(pi cutoff /
/// rate))^4): 1/sqrt(2) at the cut-off. Both ends are extended by point reflection, so that
/// straight lines pass unchanged. Values must be finite; 0 < cutoff_hz < rate_hz / 2.
std::vector<double> low_pass_filter(const std::vector<double>& values, double rate_hz,
                                    double cutoff_hz);

}  // namespace morphe::math
