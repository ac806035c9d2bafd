#pragma once

#include <vector>

#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// Returns true if the hand only closes or opens in the unit: its wrist is displaced by less than a
/// quarter of the index tip's displacement, and its aperture changes by more than half of that.
bool is_finger_motion(const HandSignals& signals, const MovementUnit& unit);

/// Extends movement units by the finger motion at their ends. A hand that closes as it arrives
/// often takes longer than the arm, and one that lets go begins earlier. The tip is slow for a
/// while in between, as arm and finger move in opposite directions, and then faster again; the
/// aperture changes throughout. Therefore a unit that is not weak is extended over a change of the
/// aperture at its end that has no pause and exceeds closing_share of the range of the aperture in
/// the recording. The fastest frame in that change becomes the unit's last (or first) peak, if its
/// speed exceeds max(onset_share · peak speed, 4 · speed_noise). A unit is extended no farther than
/// the slowest instant before the next unit that is not weak. Weak units that overlap an extended
/// one are removed. Without an aperture there is no change.
void extend_by_finger_motion(const HandSignals& signals, const SegmentOptions& options,
                             std::vector<MovementUnit>& units);

}  // namespace morphe::segment
