#pragma once

#include <vector>

#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// Splits the first unit of a movement without a grasp where the hand arrives, if it goes on there
/// without a pause (strokes through the hair). It arrives at the first minimum of the speed after
/// it falls below a quarter of its peak, if it then stays below 0.35 of the peak for 0.3 s, and
/// exceeds that later in the unit. A hand that only slows down at the end of its reach is left
/// alone. Returns true if the unit was split.
bool split_at_arrival(const HandSignals& signals, const SegmentOptions& options,
                      std::vector<MovementUnit>& units);

}  // namespace morphe::segment
