#include "stages/segment/speed_crossing.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::segment {
namespace {

/// Least level that can be measured directly, as a multiple of the noise rms.
constexpr double kMinLevelNoiseRatio = 2;
constexpr double kFlankPeakShare = 0.35;      ///< share of the peak over which the flank is fitted
constexpr double kMaxExtrapolation_s = 0.15;  ///< limit of the extrapolation
/// A flank ends when the speed falls to this share of its own peak.
constexpr double kPeakFallShare = 0.8;

double share_of_time(double share_of_peak) {
  return (1 - std::sqrt(1 - std::sqrt(std::clamp(share_of_peak, 0.0, 1.0)))) / 2;
}

/// The frames from `at` in one direction: position k is frame at + k * step.
struct Walk {
  const std::vector<double>& speed;
  std::size_t at;
  int step;
  std::size_t frame(std::size_t k) const { return at + step * static_cast<std::ptrdiff_t>(k); }
  double operator[](std::size_t k) const { return speed[frame(k)]; }
};

/// Returns the number of steps from `crossing` (positive: towards the peak) at which the fitted
/// flank has speed `level`; `crossing` if the flank cannot be fitted.
double extrapolate_flank(const Walk& inward, std::size_t first, std::size_t last, double low,
                         double level) {
  double top = 0;
  std::size_t end = first;
  for (std::size_t k = first; k <= last && inward[k] >= kPeakFallShare * top; ++k) {
    top = std::max(top, inward[k]);
    end = k;
  }
  double count = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t k = first; k <= end && inward[k] <= low + kFlankPeakShare * top; ++k) {
    const double x = share_of_time(inward[k] / top), y = static_cast<double>(k);
    count += 1;
    const double dx = x - mean_x, dy = y - mean_y;
    mean_x += dx / count;
    mean_y += dy / count;
    xx += dx * (x - mean_x);
    xy += dx * (y - mean_y);
  }
  if (count < 3 || !(xx > 0) || !(xy > 0)) return static_cast<double>(first);
  return mean_y + xy / xx * (share_of_time(level / top) - mean_x);
}

}  // namespace

SpeedCrossing find_speed_crossing(const HandSignals& signals, std::size_t rest, std::size_t peak,
                                  double level, double part) {
  const Walk inward{signals.speed, rest, rest < peak ? 1 : -1};
  const std::size_t count = rest < peak ? peak - rest : rest - peak;
  const double top = inward[count];
  const double low =
      std::max(level, std::min(kMinLevelNoiseRatio * signals.speed_noise, 0.5 * top));
  const auto gap = static_cast<std::size_t>(kMaxMergeGap_s / signals.step_s);
  std::size_t k = count;  // outermost frame that belongs to the motion
  for (std::size_t i = count, run = 0; i-- > 0;) {
    const bool fast = inward[i] > low;
    run = fast ? run + 1 : 0;
    if (fast && (k == i + 1 || inward[i] > part)) {
      k = i;
    } else if (k - i - run > gap) {
      break;
    }
  }
  double at = static_cast<double>(k);
  if (k > 0 && inward[k - 1] < inward[k]) {
    at -= std::clamp((inward[k] - low) / (inward[k] - inward[k - 1]), 0.0, 1.0);
    if (low > level) {
      const double earliest = std::max(0.0, at - kMaxExtrapolation_s / signals.step_s);
      at = std::clamp(extrapolate_flank(inward, k, count, low, level), earliest, at);
    }
  }
  SpeedCrossing edge;
  edge.frame = static_cast<double>(rest) + inward.step * at;
  const std::size_t before = k >= 2 ? k - 2 : 0, after = std::min(count, k + 2);
  const double rise = std::max(inward[after] - inward[before], 1e-9);
  edge.time_sd_s =
      signals.speed_noise * static_cast<double>(after - before) * signals.step_s / rise;
  return edge;
}

}  // namespace morphe::segment
