#pragma once

#include <functional>

#include "stages/verify/wrench_set.hpp"

namespace morphe::verify {

/// Bounds of a value: lower <= value <= upper.
struct Bounds {
  double lower = -kInfinity, upper = kInfinity;
};

/// Computes bounds of Ferrari and Canny's epsilon, min over |u| = 1 of h(u), for normal forces that
/// sum to 1. The upper bound is h(u) of the best u found by a descent from many starts. The lower
/// bound is the larger of two values: the least distance from 0 to a facet of the convex hull of
/// attainable wrenches, and minus the length of the shortest such wrench found. The bounds are
/// normally as close as 5 % or 1e-3; the search also ends as soon as the bounds `said` are
/// confirmed to that accuracy.
Bounds epsilon_bounds(const WrenchSet& pressing, const Bounds& said = {});

/// A convex function with g(s u) = s g(u) >= 0 for s > 0.
using Gauge = std::function<double(const Vector6&)>;
/// Computes bounds of the least h(u) / g(u) for normal forces that are each at most 1, to the same
/// accuracy. Never below 0.
Bounds least_ratio_bounds(const WrenchSet& pressing, const Gauge& g, const Bounds& said = {});

}  // namespace morphe::verify
