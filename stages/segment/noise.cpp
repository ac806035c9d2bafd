#include "stages/segment/noise.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/math/statistics.hpp"
#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

double squared(double value) { return value * value; }
double squared(const Vec3& value) { return value.squaredNorm(); }

/// Returns the variance of n > 2 values about their least-squares line: the sum of squares / (n −
/// 2).
template <class T>
double line_fit_variance(std::span<const T> values) {
  const double n = static_cast<double>(values.size()), middle = 0.5 * (n - 1);
  T mean = values[0] - values[0], slope = mean;  // 0 of this type
  for (int k = 0; k < std::ssize(values); ++k) {
    mean += values[k] / n;
    slope += (k - middle) * values[k];
  }
  slope /= n * (n * n - 1) / 12;
  double sum = 0;
  for (int k = 0; k < std::ssize(values); ++k)
    sum += squared(T(values[k] - mean - (k - middle) * slope));
  return sum / (n - 2);
}

template <class T>
double rms_of_quiet_windows(const std::vector<T>& values, double step_s) {
  const std::span<const T> all(values);
  const auto count =
      static_cast<std::size_t>(std::max(double{kMinNoiseWindowFrames}, kNoiseWindow_s / step_s));
  std::vector<double> variances;
  for (std::size_t i = 0; i + count <= all.size(); i += count / 2)
    variances.push_back(line_fit_variance(all.subspan(i, count)));
  if (variances.empty()) return 0;
  return std::sqrt(math::lower_quantile(std::move(variances), kQuietWindowShare));
}

}  // namespace

double noise_rms(const std::vector<Vec3>& values, double step_s) {
  return rms_of_quiet_windows(values, step_s);
}
double noise_rms(const std::vector<double>& values, double step_s) {
  return rms_of_quiet_windows(values, step_s);
}

}  // namespace morphe::segment
