#pragma once

#include <functional>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// A local minimum of a function of three variables inside |x_k| <= limit, from zero: along each
/// axis as far as it gains, in steps of limit / 2, then half of that, down to `finest`. For
/// functions without a gradient. The same function gives the same bits.
Vec3 compass_search(const std::function<double(const Vec3&)>& function, double limit,
                    double finest);

}  // namespace morphe::map
