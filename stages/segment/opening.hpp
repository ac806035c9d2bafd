#pragma once

#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// What the hand's opening did in a reach.
struct Opening {
  bool known = false;
  bool widens = false;    ///< by widening_share of what it was, and by more than its noise
  bool closes = false;    ///< again, by closing_share of the widening
  double widest_s = 0;    ///< where it was widest in the reach
  double preshape_s = 0;  ///< where it began to widen (the reach's begin if it did not)
  double confidence = 1;  ///< how far it widened beyond what is asked for, 0 … 1

  bool grasps() const { return widens && closes; }
};

/// The opening in a reach, and whether it has closed by `closed_by_s`, when the next motion begins.
Opening opening_in(const HandSignals& signals, const SegmentOptions& options, double reach_begin_s,
                   double reach_end_s, double closed_by_s);

}  // namespace morphe::segment
