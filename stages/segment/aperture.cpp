#include "stages/segment/aperture.hpp"

#include <algorithm>

#include "stages/segment/constants.hpp"

namespace morphe::segment {

ReachAperture measure_aperture(const HandSignals& signals, const SegmentOptions& options,
                               double reach_begin_s, double reach_end_s, double closed_by_s) {
  ReachAperture result;
  result.preshape_s = reach_begin_s;
  if (signals.aperture.empty()) return result;
  result.known = true;
  const std::vector<double>& opening = signals.aperture;
  const int first = signals.frame(reach_begin_s), end = signals.frame(reach_end_s);
  const int closed = std::max(end, signals.frame(closed_by_s));
  const auto widest = std::max_element(opening.begin() + first, opening.begin() + end + 1);
  const double before = opening[first], rise = *widest - before;
  const double noise = kMinApertureNoiseRatio * signals.aperture_noise;
  const double fall = *widest - *std::min_element(widest, opening.begin() + closed + 1);
  const double required = std::max(options.opening_share * before, noise);
  result.widens = rise > required;
  result.closes = fall > std::max(options.closing_share * rise, noise);
  if (!(rise > 0)) return result;
  int opens = first;
  while (opens < end && opening[opens] < before + options.preshape_share * rise) ++opens;
  result.preshape_s = signals.time(opens);
  result.confidence = std::clamp(rise / (2 * required), 0.0, 1.0);
  return result;
}

}  // namespace morphe::segment
