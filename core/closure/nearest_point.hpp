#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// Bounds the negative distance of 0 from an L1 set of at least one contact: min over |u| = 1 of
/// h(u) is in [-|x|, h(-x / |x|)] for every point x of the set. x is the nearest point of the hull
/// of more and more support points (Wolfe 1976). It ends if the bounds are close enough and both
/// negative, if 0 is in the set to rounding, if rounding prevents progress, or by max_insertions.
Bounds negative_origin_distance(const WrenchSet& set, const BoundTolerance& tolerance);

}  // namespace morphe::closure
