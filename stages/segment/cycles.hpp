#pragma once

#include <vector>

#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_unit.hpp"
#include "stages/segment/objects.hpp"

namespace morphe::segment {

/// Consecutive movement units that form one movement: out to a target, and back if `returns_home`.
struct Cycle {
  int first = 0, count = 0;   ///< first unit and number of units
  bool returns_home = false;  ///< true if `home`, see find_cycles(), is positive
  bool goes_on = false;       ///< true if the last unit leaves the object for the next grasp
};

/// Returns true if an object moves with this hand for more than half of the unit, or the unit
/// contains more than half of a motion of an object.
bool is_transport(const MovementUnit& unit, const std::vector<ObjectMotion>& motions);

/// Splits the n movement units of a recording into movements. Dynamic programming over the
/// boundaries 0 … n before, between and after the units finds the split with the highest sum of
/// scores. A movement has at most 12 units; the first is its reach. All distances are those of the
/// hand. The score of a movement is its number of units times the sum of ¼ and
///   home    max(−1, 1 − (d / h)²), with d the distance between the movement's start and end,
///           h = min(return_radius, half the displacement of the reach); at least 0 if the last
///           unit is its last, as the return may be missing. For each unit between its reach and
///           its last, the value for that unit's end is subtracted if positive.
///   carry   1 if the hand moves an object after the reach; also −1 if it does during the reach
///   grasp   only if the hand moves no object after the reach: ½ if it holds one before the next
///           unit; otherwise ½ if the aperture widens and closes, −½ if it does not, 0 if unknown
///   away    how much farther from the shoulder, horizontally, the reach ends than it starts, over
///           the displacement of the reach; 0 if the shoulder is unknown
///   target  ¼ if the reach more than halves the distance to a recorded object
/// A unit outside of movements costs min(1, extent / return_radius). Instead, the first 1 … 12
/// units may cost 0.1 together, as a movement whose reach was not recorded, or 0 if the recording
/// begins inside the first. Only the last unit can be a movement alone. A reach ends at least
/// `min_reach_distance` from its start; if the recording begins or ends inside it, its speed peak
/// is recorded.
///
/// `leaves` are the flags of LeavingUnits: such a unit can only be the last of a movement, not
/// alone, and `home` of that movement is at least 0, as the hand does not mean to go home.
std::vector<Cycle> find_cycles(const HandRecord& hand, const std::vector<MovementUnit>& units,
                               const std::vector<bool>& leaves);

}  // namespace morphe::segment
