#include "stages/segment/noise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"

namespace morphe::segment {
namespace {

constexpr double kWindow_s = 0.25, kQuietWindowShare = 0.1;

double squared(double value) { return value * value; }
double squared(const Vec3& value) { return value.squaredNorm(); }

/// Returns the mean square of values[first …, count] about their least-squares line, for count > 2.
template <class T>
double line_fit_variance(const std::vector<T>& values, std::size_t first, std::size_t count) {
  const double n = static_cast<double>(count), middle = 0.5 * (n - 1);
  T mean = values[first] - values[first], slope = mean;
  for (std::size_t k = 0; k < count; ++k) {
    mean += values[first + k] / n;
    slope += (static_cast<double>(k) - middle) * values[first + k];
  }
  slope /= n * (n * n - 1) / 12;
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    sum += squared(T(values[first + k] - mean - (static_cast<double>(k) - middle) * slope));
  }
  return sum / (n - 2);
}

template <class T>
double rms_of_quiet_windows(const std::vector<T>& values, double step_s) {
  const auto count = std::max<std::size_t>(4, static_cast<std::size_t>(kWindow_s / step_s));
  std::vector<double> windows;
  for (std::size_t i = 0; i + count <= values.size(); i += count / 2) {
    windows.push_back(line_fit_variance(values, i, count));
  }
  if (windows.empty()) return 0;
  return std::sqrt(math::lower_quantile(std::move(windows), kQuietWindowShare));
}

}  // namespace

double noise_rms(const std::vector<Vec3>& values, double step_s) {
  return rms_of_quiet_windows(values, step_s);
}
double noise_rms(const std::vector<double>& values, double step_s) {
  return rms_of_quiet_windows(values, step_s);
}

}  // namespace morphe::segment
