#pragma once

#include <cstddef>

namespace morphe::math {

/// Computes sine and cosine of many angles: sin(x) to sine[i], cos(x) to cosine[i], x = angle[i] in
/// rad. The code has no branches, so that the compiler can vectorise it. The error is at most 5e-16
/// for |x| < 1e5; for larger angles (and NaN) the standard library is used.
void sine_cosine(const double* angle, std::size_t count, double* sine, double* cosine);

}  // namespace morphe::math
