#include "stages/reconstruct/clock_offset.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::reconstruct {
namespace {

constexpr double kMaxOffset_s = 0.5;

/// Sums over the pairs of samples that coincide after a shift, each signal less its mean.
struct CorrelationSums {
  double product = 0, reference = 0, other = 0, count = 0;

  double correlation() const {
    return reference > 0 && other > 0 ? product / std::sqrt(reference * other) : 0;
  }
};

CorrelationSums correlation_sums(const std::vector<PairedSignal>& signals, std::ptrdiff_t shift) {
  CorrelationSums sums;
  for (const auto& [reference, other] : signals) {
    const std::ptrdiff_t n = std::ssize(reference);
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0, count = 0;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -shift); i < std::min(n, n - shift); ++i) {
      const double x = reference[i], y = other[i + shift];
      if (!std::isfinite(x * y)) continue;
      a += x;
      b += y;
      aa += x * x;
      bb += y * y;
      ab += x * y;
      ++count;
    }
    if (count < 2) continue;
    sums.product += ab - a * b / count;
    sums.reference += aa - a * a / count;
    sums.other += bb - b * b / count;
    sums.count += count;
  }
  return sums;
}

std::vector<double> rates(const std::vector<double>& values, double rate_hz) {
  std::vector<double> rate;
  for (int i = 1; i < std::ssize(values); ++i) {
    rate.push_back((values[i] - values[i - 1]) * rate_hz);
  }
  return rate;
}

}  // namespace

ClockOffset clock_offset(const std::vector<PairedSignal>& raw, double rate_hz, double cutoff_hz) {
  std::vector<PairedSignal> changes;
  for (const auto& [reference, other] : raw) {
    changes.push_back({rates(reference, rate_hz), rates(other, rate_hz)});
  }
  const std::ptrdiff_t max_shift = std::lround(std::ceil(kMaxOffset_s * rate_hz));
  std::vector<double> correlation;
  for (std::ptrdiff_t shift = -max_shift; shift <= max_shift; ++shift) {
    correlation.push_back(correlation_sums(changes, shift).correlation());
  }
  const auto best = std::ranges::max_element(correlation);
  const std::ptrdiff_t shift = best - correlation.begin() - max_shift;
  const CorrelationSums sums = correlation_sums(changes, shift);
  ClockOffset offset;
  offset.correlation = *best;
  offset.rate_rms = std::sqrt(std::min(sums.reference, sums.other) / std::max(1.0, sums.count));
  const double second_difference = best == correlation.begin() || best + 1 == correlation.end()
                                       ? 0
                                       : 2 * best[0] - best[-1] - best[1];
  if (!(second_difference > 0)) {
    offset.offset_sd_s = kMaxOffset_s;
    return offset;
  }
  const double fraction = (best[1] - best[-1]) / (2 * second_difference);
  offset.offset_s = (static_cast<double>(shift) + fraction) / rate_hz;
  const double curvature = second_difference * rate_hz * rate_hz;
  const double independent = 2 * cutoff_hz * sums.count / rate_hz;
  offset.offset_sd_s = std::sqrt(std::max(0.0, 1 - *best * *best) / (curvature * independent));
  return offset;
}

bool is_reliable(const ClockOffset& offset) {
  return offset.correlation > 0.6 && offset.offset_sd_s < 0.02;
}

}  // namespace morphe::reconstruct
