#pragma once

#include <vector>

namespace morphe::math {

/// The value below which a share of the values lies (nearest rank), NaN if there is none.
double quantile(std::vector<double> values, double share);

/// Over the values that are numbers, NaN if there is none.
double mean(const std::vector<double>& values);

}  // namespace morphe::math
