#pragma once

#include <cstddef>
#include <vector>

#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_units.hpp"
#include "stages/segment/objects.hpp"

namespace morphe::segment {

/// Consecutive movement units that form one movement: out to a target, and back if `returns_home`.
struct Cycle {
  std::size_t first = 0, count = 0;  ///< first unit and number of units
  /// True if the movement ends at its start.
  bool returns_home = false;
};

/// Returns true if an object was moving during most of the unit (or all its motion is inside the
/// unit).
bool is_transport(const MovementUnit& bout, const std::vector<ObjectMotion>& motions);

/// Splits the movement units of a recording into movements. The split with the highest sum of
/// evidence is found by dynamic programming over the rests between units. The evidence of a
/// movement from rest i to rest j is its number of units times the sum of ¼ and
///   home    1 − (d / h)², at least −1, with d the distance of rest j from rest i and h =
///           return_radius, or half the reach if that is less; at least 0 if the recording ends
///           before the return; the same value, if positive, is subtracted for every rest in
///           between that is at home
///   grasp   1 if the hand moves an object after the reach; otherwise ½ if it holds one before
///           the next unit or the aperture is known to widen and close, −½ if the aperture is
///           known not to; and −1 if the hand moves an object during the reach
///   away    the horizontal distance from the shoulder gained by the reach, over the length of
///           the reach
///   target  ¼ if the reach halves the distance to a recorded object
/// Units outside of movements cost up to 1 each, depending on their displacement. Those at the
/// start of a recording cost 0.1 together, and 0 if the recording begins inside one: they are the
/// rest of a movement without its reach. A movement never begins with a unit that is not a reach,
/// that is one that ends less than `min_reach_distance` from its start, or is truncated by the
/// start of the recording after its peak or by the end of the recording before its peak.
std::vector<Cycle> find_cycles(const HandSignals& signals, const HumanMotion& motion,
                               const SegmentOptions& options,
                               const std::vector<MovementUnit>& bouts,
                               const std::vector<SceneObject>& objects,
                               const std::vector<ObjectMotion>& motions,
                               const std::vector<HandObjectInteraction>& contacts);

}  // namespace morphe::segment
