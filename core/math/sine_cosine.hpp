#pragma once

#include <cstddef>

namespace morphe::math {

/// Sine and cosine of many angles at once: sin(x) to sine[i], cos(x) to cosine[i], x = angle[i] in
/// rad. Without branches, so that the compiler takes several angles per instruction; within 5e-16
/// of the true value for |x| < 1e5, beyond that (and for NaN) the standard library's.
void sine_cosine(const double* angle, std::size_t count, double* sine, double* cosine);

}  // namespace morphe::math
