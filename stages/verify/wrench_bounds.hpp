#pragma once

#include <functional>

#include "stages/verify/wrench_set.hpp"

namespace morphe::verify {

/// Bounds of a value: lower <= value <= upper.
struct Bounds {
  double lower = -kInfinity, upper = kInfinity;
};

/// Computes bounds of Ferrari and Canny's epsilon, min over |u| = 1 of h(u), for normal forces that
/// sum to 1 (limits_each_force must be false). The upper bound is the least h(u) found. The lower
/// bound is the larger of the least distance from 0 to a facet of the convex hull of attainable
/// wrenches, and minus the length of the shortest such wrench found. The search ends at a gap of
/// 5 % of the lower bound or 1e-3, when it confirms `claimed` to that accuracy, or at its limits.
Bounds epsilon_bounds(const WrenchSet& wrenches, const Bounds& claimed = {});

/// A convex function with g(s u) = s g(u) >= 0 for s > 0.
using Gauge = std::function<double(const Vector6&)>;
/// Computes bounds of the least h(u) / g(u) over all u with g(u) > 0, for normal forces that are
/// each at most 1 (limits_each_force must be true), to the same accuracy. Both are at least 0.
Bounds least_ratio_bounds(const WrenchSet& wrenches, const Gauge& g, const Bounds& claimed = {});

}  // namespace morphe::verify
