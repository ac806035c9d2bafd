#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

// Of n values in ascending order, x[0] <= … <= x[n - 1].

/// Returns x[ceil(share n) - 1], or x[0] for a share of 0: the quantile by nearest rank, for a
/// share in [0, 1]; NaN if there are no values.
double quantile(std::vector<double> values, double share);

/// Returns x[floor(share (n - 1))], for a share in [0, 1]: of the two values between which a linear
/// interpolation would lie the lower one; NaN if there are no values.
double lower_quantile(std::vector<double> values, double share);

/// Returns x[floor(n / 2)], the middle value, of an even number the upper one of the two in the
/// middle; NaN if there are no values.
double median(std::vector<double> values);

/// Returns the middle value, of an even number the mean of the two in the middle,
/// (x[n / 2 - 1] + x[n / 2]) / 2; NaN if there are no values.
double midpoint_median(std::vector<double> values);

/// Returns median() of each coordinate over the known points, in their unit; unknown if no point is
/// known.
Vec3 median_point(const std::vector<Vec3>& points);

/// Returns median() of the distances between two tracks of equal length over the frames in which
/// both are known, in their unit; NaN if there are no such frames.
double median_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to);

/// Returns the mean of the values that are not NaN; NaN if there are no such values.
double mean(const std::vector<double>& values);

}  // namespace morphe::math
