#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// The distance of 0 from a set (of L1), as a number below 0: min over |u| = 1 of h(u) lies in
/// [-|x|, h(-x / |x|)] for every point x of it. x is the nearest point of the hull of ever more
/// support points (Wolfe 1976). Ends when the bounds are near enough and both below 0; when 0 is in
/// the set to rounding (then the upper bound is that of the twists that were asked); or where
/// rounding lets nothing more be gained.
Bounds distance_below_zero(const WrenchSet& set, const Tolerance& tolerance);

}  // namespace morphe::closure
