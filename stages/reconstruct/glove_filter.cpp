#include "stages/reconstruct/glove_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/low_pass.hpp"
#include "core/math/statistics.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kPowerHalfWindow_s = 0.1;
/// Values of chi² per degree of freedom that noise exceeds by chance in 2 % of the cases: a band of
/// 6 Hz has 2.4 degrees of freedom in 0.2 s, 22 columns together have 53.
constexpr double kSingleColumnChi2Ratio = 4, kAllColumnsChi2Ratio = 1.5;

double noise_variance(const std::vector<double>& column) {
  std::vector<double> second_differences;
  for (int i = 2; i < std::ssize(column); ++i) {
    const double second_difference = column[i] - 2 * column[i - 1] + column[i - 2];
    if (std::isfinite(second_difference)) second_differences.push_back(std::abs(second_difference));
  }
  if (second_differences.empty()) return 0;
  const double deviation = math::median(std::move(second_differences)) / 0.6745;
  return deviation * deviation / 6;
}

/// Returns the share of white noise's variance in the band that only the faster filter passes.
double band_gain(const std::vector<double>& time, const TimeGrid& clock, double fast_hz,
                 double slow_hz) {
  const std::ptrdiff_t half = std::lround(std::floor(4 * clock.rate_hz / slow_hz));
  std::vector<double> impulse(2 * half + 1, 0.0);
  impulse[half] = 1;
  const std::vector<double> fast = math::low_pass_filter(impulse, clock.rate_hz, fast_hz);
  const std::vector<double> slow = math::low_pass_filter(impulse, clock.rate_hz, slow_hz);
  double gain = 0;
  for (int i = 0; i < std::ssize(fast); ++i) gain += (fast[i] - slow[i]) * (fast[i] - slow[i]);
  const double glove_hz = static_cast<double>(time.size() - 1) / (time.back() - time.front());
  return gain * clock.rate_hz / glove_hz;
}

/// The mean of the finite values in a window of frames, from cumulative sums; finish() before use.
class LocalMean {
 public:
  explicit LocalMean(int frames) : sum_(frames + 1, 0.0), count_(frames + 1, 0.0) {}
  void add(int frame, double value) {
    if (!std::isfinite(value)) return;
    sum_[frame + 1] += value;
    count_[frame + 1] += 1;
  }
  void finish() {
    for (int i = 1; i < std::ssize(sum_); ++i) {
      sum_[i] += sum_[i - 1];
      count_[i] += count_[i - 1];
    }
  }
  double mean_around(std::ptrdiff_t frame, std::ptrdiff_t half) const {
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, frame - half);
    const std::ptrdiff_t to = std::min(std::ssize(sum_) - 1, frame + half + 1);
    return (sum_[to] - sum_[from]) / std::max(1.0, count_[to] - count_[from]);
  }

 private:
  std::vector<double> sum_, count_;
};

}  // namespace

std::vector<std::vector<double>> filter_glove(const std::vector<double>& time,
                                              const std::vector<std::vector<double>>& columns,
                                              const TimeGrid& clock,
                                              const ReconstructOptions& options) {
  ReconstructOptions at_rest = options;
  at_rest.cutoff_hz = options.glove_rest_cutoff_hz;
  std::vector<std::vector<double>> fast, slow;
  for (const auto& column : columns) fast.push_back(resample(time, column, clock, options));
  if (time.size() < 2 || at_rest.cutoff_hz >= options.cutoff_hz) return fast;
  const double gain = band_gain(time, clock, options.cutoff_hz, at_rest.cutoff_hz);
  LocalMean hand_power(clock.count);
  std::vector<LocalMean> column_power(columns.size(), LocalMean(clock.count));
  std::vector<double> noise;
  for (int k = 0; k < std::ssize(columns); ++k) {
    noise.push_back(gain * noise_variance(columns[k]));
    slow.push_back(resample(time, columns[k], clock, at_rest));
    for (int i = 0; i < clock.count && noise[k] > 0; ++i) {
      const double power = (fast[k][i] - slow[k][i]) * (fast[k][i] - slow[k][i]) / noise[k];
      column_power[k].add(i, power);
      hand_power.add(i, power);
    }
    column_power[k].finish();
  }
  hand_power.finish();
  const std::ptrdiff_t half = std::lround(std::floor(kPowerHalfWindow_s * clock.rate_hz));
  for (int k = 0; k < std::ssize(columns); ++k) {
    for (int i = 0; i < clock.count && noise[k] > 0; ++i) {
      const double power = std::max(column_power[k].mean_around(i, half) / kSingleColumnChi2Ratio,
                                    hand_power.mean_around(i, half) / kAllColumnsChi2Ratio);
      const double weight = power > 1 ? 1 - 1 / power : 0;
      fast[k][i] = slow[k][i] + weight * (fast[k][i] - slow[k][i]);
    }
  }
  return fast;
}

}  // namespace morphe::reconstruct
