#pragma once

#include <cstddef>

namespace morphe::math {

/// Computes sine[i] = sin(x) and cosine[i] = cos(x) of x = angle[i] in rad; the arrays must not
/// overlap. There are no branches, so that the compiler can vectorise. The error is at most 5e-16
/// for |x| < 1e5; for larger angles (and NaN) the standard library is used.
void sine_cosine(const double* angle, std::size_t count, double* sine, double* cosine);

}  // namespace morphe::math
