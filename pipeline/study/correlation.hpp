#pragma once

#include <vector>

namespace morphe::study {

/// Returns Pearson's correlation of two series of the same length; NaN for fewer than two values
/// and for a constant series.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace morphe::study
