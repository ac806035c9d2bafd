#include "core/math/sine_cosine.hpp"

#include <cmath>

namespace morphe::math {
namespace {

constexpr double kMaxAngle_rad = 1e5;
/// Adding and subtracting this constant rounds to the nearest integer.
constexpr double kRoundingShift = 0x1.8p52;
/// Pi in three parts; products of the first two with integers are exact.
constexpr double kPiHigh = 0x1.921fb54440000p+1, kPiMiddle = 0x1.68c234c4c0000p-38,
                 kPiLow = 0x1.98a2e03707345p-76;

double round_to_nearest(double x) { return (x + kRoundingShift) - kRoundingShift; }

}  // namespace

void sine_cosine(const double* __restrict angle, std::size_t count, double* __restrict sine,
                 double* __restrict cosine) {
  for (std::size_t i = 0; i < count; ++i) {
    // x = k pi + 2 y with |y| <= pi/4: the Taylor series of y, then the double-angle formulas.
    const double k = round_to_nearest(angle[i] * 0.3183098861837907);
    const double y = 0.5 * (((angle[i] - k * kPiHigh) - k * kPiMiddle) - k * kPiLow);
    const double odd = k - 2 * round_to_nearest(0.5 * k);
    const double sign = 1 - 2 * odd * odd;
    const double z = y * y;
    double s = 1.0 / 355687428096000;
    s = s * z - 1.0 / 1307674368000;
    s = s * z + 1.0 / 6227020800;
    s = s * z - 1.0 / 39916800;
    s = s * z + 1.0 / 362880;
    s = s * z - 1.0 / 5040;
    s = s * z + 1.0 / 120;
    s = s * z - 1.0 / 6;
    s = y + y * (z * s);
    double c = 1.0 / 20922789888000;
    c = c * z - 1.0 / 87178291200;
    c = c * z + 1.0 / 479001600;
    c = c * z - 1.0 / 3628800;
    c = c * z + 1.0 / 40320;
    c = c * z - 1.0 / 720;
    c = c * z + 1.0 / 24;
    c = 1 + z * (c * z - 0.5);
    sine[i] = sign * (2 * s * c);
    cosine[i] = sign * (1 - 2 * s * s);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(angle[i]) < kMaxAngle_rad) continue;
    sine[i] = std::sin(angle[i]);
    cosine[i] = std::cos(angle[i]);
  }
}

}  // namespace morphe::math
