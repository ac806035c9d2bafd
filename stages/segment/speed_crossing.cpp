#include "stages/segment/speed_crossing.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

/// Returns τ at v = peak_share · p, see the header.
double rise_time(double peak_share) {
  return (1 - std::sqrt(1 - std::sqrt(std::clamp(peak_share, 0.0, 1.0)))) / 2;
}

/// The speed at the frames start + k · step, with step +1 or -1.
struct Walk {
  const std::vector<double>& speed;
  int start, step;
  double operator[](int k) const { return speed[start + step * k]; }
};

/// Returns the fractional k at which the flank has speed `level`, by a fit to the frames k = first
/// … last that belong to the flank and are above `safe_level` by at most kFlankPeakShare of its
/// peak. Returns `first` if the flank cannot be fitted.
double extrapolate_flank(const Walk& inward, int first, int last, double safe_level, double level) {
  double top = 0;
  int end = first;
  for (int k = first; k <= last && inward[k] >= kPeakFallShare * top; ++k) {
    top = std::max(top, inward[k]);
    end = k;
  }
  double count = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (int k = first; k <= end && inward[k] <= safe_level + kFlankPeakShare * top; ++k) {
    const double x = rise_time(inward[k] / top);
    count += 1;
    const double dx = x - mean_x, dy = k - mean_y;
    mean_x += dx / count;
    mean_y += dy / count;
    xx += dx * (x - mean_x);
    xy += dx * (k - mean_y);
  }
  if (count < kMinFlankFrames || !(xx > 0) || !(xy > 0)) return first;
  return mean_y + xy / xx * (rise_time(level / top) - mean_x);
}

}  // namespace

SpeedCrossing find_speed_crossing(const HandSignals& signals, int rest, int peak, double level,
                                  double min_part_speed) {
  const Walk inward{signals.speed, rest, rest < peak ? 1 : -1};
  const int count = std::abs(peak - rest);
  const double safe_level = std::max(level, std::min(kMinLevelNoiseRatio * signals.speed_noise,
                                                     kMaxLevelPeakShare * inward[count]));
  const int gap = signals.frames_in(kMaxMergeGap_s);
  // Noise rarely reaches safe_level; k is the outermost frame that belongs to the motion.
  int k = count;
  for (int i = count - 1, run = 0; i >= 0; --i) {  // run: fast frames in succession, up to i
    const bool fast = inward[i] > safe_level;
    run = fast ? run + 1 : 0;
    if (fast && (k == i + 1 || inward[i] > min_part_speed)) {
      k = i;
    } else if (k - i - run > gap) {
      break;
    }
  }
  double steps = k;  // from rest to the crossing
  if (k > 0 && inward[k - 1] < inward[k]) {
    steps -= std::clamp((inward[k] - safe_level) / (inward[k] - inward[k - 1]), 0.0, 1.0);
    if (safe_level > level) {
      const double least = std::max(0.0, steps - kMaxExtrapolation_s / signals.step_s);
      steps = std::clamp(extrapolate_flank(inward, k, count, safe_level, level), least, steps);
    }
  }
  const int before = std::max(k - 2, 0), after = std::min(count, k + 2);
  const double rise = std::max(inward[after] - inward[before], 1e-9);
  return {rest + inward.step * steps,
          signals.speed_noise * (after - before) * signals.step_s / rise};
}

}  // namespace morphe::segment
