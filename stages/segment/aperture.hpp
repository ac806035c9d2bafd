#pragma once

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The change of the hand's aperture during a reach.
struct ReachAperture {
  /// True if the aperture was recorded.
  bool known = false;
  /// True if it widens by more than opening_share of its start and by more than its noise.
  bool widens = false;
  bool closes = false;    ///< true if it closes again by closing_share of the widening
  double widest_s = 0;    ///< time of the widest aperture in the reach
  double preshape_s = 0;  ///< time at which it begins to widen (the reach's start if it does not)
  double confidence = 1;  ///< confidence from the widening relative to the required one, 0 … 1

  /// Returns true if the aperture widens and closes again.
  bool grasps() const { return widens && closes; }
};

/// Measures the aperture during a reach. The hand must have closed by `closed_by_s`, at which the
/// next motion begins.
ReachAperture measure_aperture(const HandSignals& signals, const SegmentOptions& options,
                               double reach_begin_s, double reach_end_s, double closed_by_s);

}  // namespace morphe::segment
