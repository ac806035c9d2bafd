#pragma once

#include <vector>

namespace morphe::study {

/// Computes Pearson's correlation of two series of the same length, NaN for fewer than two values.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace morphe::study
