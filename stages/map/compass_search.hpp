#pragma once

#include <functional>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// Finds a local minimum of a function of three variables inside |x_k| <= limit, starting from
/// zero. The search moves along each axis as long as the value decreases, in steps of limit / 2,
/// then half of that, down to `finest`. It is meant for functions without a gradient. The same
/// function gives the same bits.
Vec3 compass_search(const std::function<double(const Vec3&)>& function, double limit,
                    double finest);

}  // namespace morphe::map
