#pragma once

#include <functional>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// Returns a local minimum of f inside |x_k| <= limit, found without a gradient. Starts at
/// zero with steps of limit / 2 along the axes. Steps as long as one decreases the value, then
/// halves the step; ends before steps shorter than `min_step`. Returns zero if there is no step.
Vec3 compass_search(const std::function<double(const Vec3&)>& f, double limit, double min_step);

}  // namespace morphe::map
