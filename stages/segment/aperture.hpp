#pragma once

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The change of the hand's aperture during a reach.
struct ReachAperture {
  bool known = false;  ///< true if the aperture was recorded
  /// True if it widens by more than opening_share of its start and by more than its noise.
  bool widens = false;
  /// True if it narrows again by more than closing_share of the widening and than its noise.
  bool closes = false;
  double preshape_s = 0;  ///< time at which it begins to widen (the reach's start if it does not)
  double confidence = 1;  ///< clamp(widening / twice the required widening, 0, 1); 1 if unknown

  bool grasps() const { return widens && closes; }
};

/// Measures the aperture during a reach. It may close until `closed_by_s`, at which the next motion
/// begins.
ReachAperture measure_aperture(const HandSignals& signals, const SegmentOptions& options,
                               double reach_begin_s, double reach_end_s, double closed_by_s);

}  // namespace morphe::segment
