#pragma once

#include <vector>

#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// Returns the movement units of a recording in order. Two speed peaks form two units if the dip
/// between them is deep for the change of direction of the hand,
///   v_dip / v_smaller_peak < clamp(dip_share (1 − cos θ), min(0.15, dip_share), dip_share),
/// with θ the angle between the displacements before and after the dip; a correction on the way
/// must come nearly to a stop to count. `splits_s` are times [s] at which an object starts or stops
/// to move, so that a unit probably ends; it is cut at the slowest frame within 0.15 s. Units with
/// a peak below max(4 · noise, 0.2 · min_peak_speed) or a duration below 0.08 s are left out.
///
/// A weak unit is merged with a stronger one beside it if the speed between them never falls below
/// the level at which the stronger one ends, or for at most 0.1 s if the weak one's peak is at
/// least `weak_unit_share` of the stronger one's. This is a hand that closes as it arrives, or lets
/// go as it sets out. Slower closing and letting go is detected from the fingers
/// (finger_motion.hpp).
std::vector<MovementUnit> find_movement_units(const HandSignals& signals,
                                              const SegmentOptions& options,
                                              const std::vector<double>& splits_s);

}  // namespace morphe::segment
