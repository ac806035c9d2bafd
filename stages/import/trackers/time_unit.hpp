#pragma once

#include <string>
#include <vector>

namespace morphe::imports {

/// Returns the median difference of successive times, NaN for fewer than two.
double median_step(const std::vector<double>& time);

/// Returns the seconds in one unit of a column of times: `unit` ("s", "ms", "us" or "ns") or, if
/// that is "", the unit in which the median step is that of a camera, 1 ms to 1 s, which is
/// reported. Otherwise 1. Throws UnresolvedConvention "rate", prefixed by `source`, for
/// whole numbers with the step 1, which are those of frames.
double seconds_per_unit(const std::string& column, const std::string& unit,
                        const std::vector<double>& time, const std::string& source,
                        std::vector<std::string>& reports);

}  // namespace morphe::imports
