#pragma once

#include <vector>

#include "stages/segment/movement_units.hpp"

namespace morphe::segment {

/// Returns true if the hand closes or lets go: the wrist travels less than a quarter of the tip's
/// displacement, and the aperture changes by more than half of it.
bool is_finger_motion(const HandSignals& signals, const MovementUnit& bout);

/// Extends movement units by the finger motion at their ends. A hand that closes as it arrives
/// often takes longer than the arm, and one that lets go begins earlier. The tip is slow for a
/// while in between, as arm and finger move in opposite directions, and then faster again; the
/// aperture changes throughout. Therefore a unit that is not weak is extended while the hand opens
/// or closes without a pause and by more than closing_share of its largest change in the recording,
/// up to the last instant at which the tip is as fast as in a unit under way, but no farther than
/// the slowest instant before the next unit that is not weak. Weak units in between are removed.
void extend_by_finger_motion(const HandSignals& signals, const SegmentOptions& options,
                             std::vector<MovementUnit>& bouts);

}  // namespace morphe::segment
