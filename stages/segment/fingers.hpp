#pragma once

#include <vector>

#include "stages/segment/bouts.hpp"

namespace morphe::segment {

/// The wrist goes less than a quarter of the tip's way, and the opening changes by more than half
/// of it: the hand closes, or lets go.
bool only_fingers(const HandSignals& signals, const Bout& bout);

/// A hand that closes as it arrives often takes longer than the arm, and one that lets go begins
/// earlier. The tip is slow for a while between the two, where arm and finger go opposite ways, and
/// then faster again; the opening changes throughout. So the bout (no weak one) goes on while the
/// hand opens, or closes, without a pause and by more than closing_share of what it does at most in
/// the recording, to the last instant at which the tip is as fast as a bout under way; no farther
/// than to the slowest instant before the next bout that is not weak. Weak bouts on the way go.
void take_in_fingers(const HandSignals& signals, const SegmentOptions& options,
                     std::vector<Bout>& bouts);

}  // namespace morphe::segment
