#pragma once

#include <vector>

#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// Resamples the columns of a glove, [sensor][sample] at `time`, on a clock and filters them:
///   y = s + w (f - s), w = 1 - 1 / E, at least 0     (a local Wiener filter),
/// with f low-passed at cutoff_hz and s at glove_rest_cutoff_hz, so that a resting hand is smooth
/// and a moving one keeps all frequencies up to cutoff_hz. The power of a column is the mean square
/// of f - s within 0.1 s, divided by that of the glove's noise. E is the maximum of the column's
/// power and of the mean power of all columns (fingers move at the same time), each divided by the
/// value that noise exceeds by chance in 2 % of the cases. The noise is assumed white, with the
/// standard deviation
///   median of |x_{i-1} - 2 x_i + x_{i+1}| / (0.6745 sqrt(6)),
/// on which motion has little influence. Columns for which it is 0 are only low-passed, y = f, as
/// are all columns unless glove_rest_cutoff_hz is below cutoff_hz.
std::vector<std::vector<double>> filter_glove(const std::vector<double>& time,
                                              const std::vector<std::vector<double>>& columns,
                                              const TimeGrid& clock,
                                              const ReconstructOptions& options);

}  // namespace morphe::reconstruct
