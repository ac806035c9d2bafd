#pragma once

#include <vector>

#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// Filters the columns of a glove on a clock: y = s + w (f - s), with f low-passed at cutoff_hz and
/// s at glove_rest_cutoff_hz. The difference f - s is motion or noise: with E its mean square
/// within 0.1 s relative to that expected from the glove's noise,
///   w = 1 - 1 / E, at least 0     (a local Wiener filter)
/// so that a resting hand is smooth and a moving one keeps all frequencies up to cutoff_hz. E is
/// the maximum of the column's own value and that of all columns together, since fingers move at
/// the same time, each relative to the value that noise exceeds by chance in 2 % of the cases. The
/// noise is assumed white: its standard deviation is the median of |x_{i-1} - 2 x_i + x_{i+1}| /
/// (0.6745 sqrt(6)), so that motion has little influence. A glove without noise, or with a
/// resolution coarser than it, is only low-passed.
std::vector<std::vector<double>> filter_glove(const std::vector<double>& time,
                                              const std::vector<std::vector<double>>& columns,
                                              const TimeGrid& clock,
                                              const ReconstructOptions& options);

}  // namespace morphe::reconstruct
