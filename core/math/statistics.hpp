#pragma once

#include <vector>

namespace morphe::math {

/// The value below which a share of the values lies (nearest rank), NaN if there is none.
double quantile(std::vector<double> values, double share);

/// The middle one of at least one value, of an even number the upper; changes their order.
double median(std::vector<double>& values);

/// Over the values that are numbers, NaN if there is none.
double mean(const std::vector<double>& values);

}  // namespace morphe::math
