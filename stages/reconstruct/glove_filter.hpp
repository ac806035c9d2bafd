#pragma once

#include <vector>

#include "stages/reconstruct/clock.hpp"

namespace morphe::reconstruct {

/// Columns of a glove on a clock: y = s + w (f - s), with f low-passed at cutoff_hz and s at
/// glove_rest_cutoff_hz. What f has and s has not is motion or noise: with E its mean square within
/// 0.1 s, over what the glove's noise makes of it,
///   w = 1 - 1 / E, at least 0     (a local Wiener filter)
/// so that a resting hand is calm and a moving one keeps all that cutoff_hz lets through. E is the
/// greater one of the column's own and that of all columns together, since fingers move at one
/// time, each over what chance makes of it once in fifty times. Noise is white: its deviation is
/// the median of |x_{i-1} - 2 x_i + x_{i+1}| / (0.6745 sqrt(6)), so that motion does not count. A
/// glove without noise, or one whose steps are coarser than it, is only low-passed.
std::vector<std::vector<double>> filtered_glove(const std::vector<double>& time,
                                                const std::vector<std::vector<double>>& columns,
                                                const Clock& clock,
                                                const ReconstructOptions& options);

}  // namespace morphe::reconstruct
