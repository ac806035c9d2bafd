#pragma once

#include <vector>

namespace morphe::study {

/// Pearson's, of two rows of the same length; NaN below two values.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace morphe::study
