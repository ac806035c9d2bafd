#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// Computes the negative distance of 0 from a set (for L1): min over |u| = 1 of h(u) is in [-|x|,
/// h(-x / |x|)] for every point x of the set. x is the nearest point of the hull of an increasing
/// number of support points (Wolfe 1976). It ends if the bounds are close enough and both negative;
/// if 0 is in the set to rounding (the upper bound is then that of the twists evaluated so far); or
/// if rounding prevents further progress.
Bounds negative_origin_distance(const WrenchSet& set, const BoundTolerance& tolerance);

}  // namespace morphe::closure
