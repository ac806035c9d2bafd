#pragma once

#include <vector>

namespace morphe::math {

/// Returns the quantile for a share of the values (nearest rank), or NaN if there are no values.
double quantile(std::vector<double> values, double share);

/// Returns the median of at least one value, the upper one for an even number; changes their order.
double median(std::vector<double>& values);

/// Returns the mean of the values that are not NaN, or NaN if there are no such values.
double mean(const std::vector<double>& values);

}  // namespace morphe::math
