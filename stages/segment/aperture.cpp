#include "stages/segment/aperture.hpp"

#include <algorithm>

namespace morphe::segment {
ReachAperture measure_aperture(const HandSignals& signals, const SegmentOptions& options,
                               double reach_begin_s, double reach_end_s, double closed_by_s) {
  ReachAperture result;
  result.preshape_s = result.widest_s = reach_begin_s;
  if (signals.aperture.empty()) return result;
  result.known = true;
  const std::vector<double>& opening = signals.aperture;
  const auto at = [&](std::size_t i) { return opening.begin() + i; };
  const std::size_t first = signals.frame(reach_begin_s), end = signals.frame(reach_end_s);
  const std::size_t closed = std::max(end, signals.frame(closed_by_s));
  const auto widest = std::max_element(at(first), at(end) + 1);
  const double before = opening[first], rise = *widest - before;
  const double noise = kMinApertureNoiseRatio * signals.aperture_noise;
  const double fall = *widest - *std::min_element(widest, at(closed) + 1);
  const double asked = std::max(options.opening_share * before, noise);
  result.widest_s = signals.time(static_cast<double>(widest - opening.begin()));
  result.widens = rise > asked;
  result.closes = fall > std::max(options.closing_share * rise, noise);
  if (!(rise > 0)) return result;
  std::size_t opens = first;
  while (opens < end && opening[opens] < before + options.preshape_share * rise) ++opens;
  result.preshape_s = signals.time(static_cast<double>(opens));
  result.confidence = std::clamp(rise / (2 * asked), 0.0, 1.0);
  return result;
}

}  // namespace morphe::segment
