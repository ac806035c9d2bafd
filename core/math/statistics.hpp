#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

// x[0] <= … <= x[n - 1] are the n values in ascending order; shares are in [0, 1].

/// Returns the quantile by nearest rank, x[max(0, ceil(share n) - 1)]; NaN without values.
double quantile(std::vector<double> values, double share);

/// Returns x[floor(share (n - 1))]: the lower of the two values between which a linear
/// interpolation would lie; NaN if there are no values.
double lower_quantile(std::vector<double> values, double share);

/// Returns x[floor(n / 2)], the upper one of two in the middle; NaN if there are no values.
double median(std::vector<double> values);

/// Returns the middle value, or the mean of two in the middle; NaN if there are no values.
double midpoint_median(std::vector<double> values);

/// Returns median() of each coordinate over the known points; unknown if no point is known.
Vec3 median_point(const std::vector<Vec3>& points);

/// Returns median() of the distances of two equally long tracks where both are known, or NaN.
double median_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to);

/// Returns the mean of the values that are not NaN; NaN if there are no such values.
double mean(const std::vector<double>& values);

/// Returns Pearson's correlation of two series of the same length; NaN for fewer than two values
/// and for a constant series.
double correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace morphe::math
