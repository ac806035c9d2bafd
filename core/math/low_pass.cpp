#include "core/math/low_pass.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace morphe::math {
namespace {

struct Butterworth {
  double b0, b1, b2, a1, a2;

  /// `k` is the tangent of the pre-warped cut-off.
  explicit Butterworth(double k) {
    const double scale = 1 / (1 + std::numbers::sqrt2 * k + k * k);
    b0 = b2 = k * k * scale;
    b1 = 2 * b0;
    a1 = 2 * (k * k - 1) * scale;
    a2 = (1 - std::numbers::sqrt2 * k + k * k) * scale;
  }
  /// Filters in place, as if the first value had been constant before.
  void run(std::vector<double>& values) const {
    double x1 = values.front(), x2 = x1, y1 = x1, y2 = x1;
    for (double& value : values) {
      const double y = b0 * value + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2;
      x2 = x1;
      x1 = value;
      y2 = y1;
      y1 = y;
      value = y;
    }
  }
};

}  // namespace

std::vector<double> low_pass_filter(const std::vector<double>& values, double rate_hz,
                                    double cutoff_hz) {
  assert(cutoff_hz > 0 && cutoff_hz < rate_hz / 2);
  const std::ptrdiff_t n = std::ssize(values);
  if (n < 2) return values;
  // The reflection covers the filter's memory: about three periods of the cut-off decay to 1e-6.
  const auto pad = std::min(n - 1, static_cast<std::ptrdiff_t>(3 * rate_hz / cutoff_hz) + 1);
  std::vector<double> padded;
  padded.reserve(n + 2 * pad);
  for (std::ptrdiff_t i = pad; i > 0; --i) padded.push_back(2 * values.front() - values[i]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::ptrdiff_t i = 1; i <= pad; ++i) padded.push_back(2 * values.back() - values[n - 1 - i]);

  // Two passes multiply the gains, so the cut-off of each is higher by (sqrt(2) - 1)^(-1/4).
  const double widen = std::pow(std::numbers::sqrt2 - 1, -0.25);
  const Butterworth filter(std::tan(std::numbers::pi * cutoff_hz / rate_hz) * widen);
  filter.run(padded);
  std::ranges::reverse(padded);
  filter.run(padded);
  std::ranges::reverse(padded);
  return {padded.begin() + pad, padded.end() - pad};
}

}  // namespace morphe::math
