#include "stages/segment/next_grasp.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"
#include "stages/segment/cycles.hpp"

namespace morphe::segment {
namespace {

/// The units in which the hand is free, from the last one that carries an object to the next, and
/// its distances from both objects.
struct FreeUnits {
  int first = 0, end = 0;
  const HandObjectInteraction *before = nullptr, *after = nullptr;
};

/// Returns the object that moves with this hand in a unit, or null.
const HandObjectInteraction* carried_object(const HandRecord& hand, const MovementUnit& unit) {
  for (const ObjectMotion& motion : hand.motions) {
    if (!overlap_in_time(unit, motion)) continue;
    const auto own =
        std::ranges::find(hand.interactions, motion.object, &HandObjectInteraction::object);
    if (own != hand.interactions.end()) return &*own;
  }
  return nullptr;
}

/// Returns the distance from the nearer one of both objects at a frame; 0 if it is unknown.
double clearance(const FreeUnits& free, int frame) {
  const double distance_m = std::min(free.before->distance[frame], free.after->distance[frame]);
  return std::isnan(distance_m) ? 0 : distance_m;
}

/// Returns the frame of the unit at which the hand is farthest from both objects.
int farthest_frame(const HandSignals& signals, const MovementUnit& unit, const FreeUnits& free) {
  int farthest = signals.frame(unit.begin_s);
  for (int frame = farthest; frame <= signals.frame(unit.end_s); ++frame)
    if (clearance(free, frame) > clearance(free, farthest)) farthest = frame;
  return farthest;
}

/// Returns true if the hand takes another object, or was away from the one that it takes again.
bool is_new_grasp(const HandSignals& signals, const std::vector<MovementUnit>& units,
                  const FreeUnits& free) {
  if (free.before != free.after) return true;
  return std::any_of(
      units.begin() + free.first, units.begin() + free.end, [&](const MovementUnit& unit) {
        return clearance(free, farthest_frame(signals, unit, free)) > kMaxHandDistance_m;
      });
}

/// Returns the free units between two transports, in order.
std::vector<FreeUnits> free_units(const HandRecord& hand, const std::vector<MovementUnit>& units) {
  std::vector<FreeUnits> all;
  int last = -1;  // unit that carries something
  const HandObjectInteraction* before = nullptr;
  for (int k = 0; k < std::ssize(units); ++k) {
    const HandObjectInteraction* own = carried_object(hand, units[k]);
    if (!own) continue;
    if (last >= 0 && k > last + 1) all.push_back({last + 1, k, before, own});
    last = k;
    before = own;
  }
  return all;
}

/// Returns true if one of the free units ends where the hand set out for the object before.
bool goes_home(const HandRecord& hand, const std::vector<MovementUnit>& units,
               const FreeUnits& free) {
  int reach = free.first - 1;
  while (reach > 0 && is_transport(units[reach], hand.motions)) --reach;
  const Vec3& home = units[reach].start_position;
  return std::any_of(units.begin() + free.first, units.begin() + free.end,
                     [&](const MovementUnit& unit) {
                       return (unit.end_position - home).norm() < hand.options.return_radius;
                     });
}

/// Divides a unit at a frame. The cut is no rest; its confidence is that of the unit's own end.
std::pair<MovementUnit, MovementUnit> divide(const HandSignals& signals, const MovementUnit& unit,
                                             int frame) {
  MovementUnit before = unit, after = unit;
  before.last = after.first = frame;
  before.peak = before.first_peak = before.last_peak = fastest_frame(signals, unit.first, frame);
  after.peak = after.first_peak = after.last_peak = fastest_frame(signals, frame, unit.last);
  before.end_s = after.begin_s = signals.time(frame);
  before.end_position = after.start_position = signals.position[frame];
  before.end_truncated = after.begin_truncated = false;
  before.extent = before.displacement().norm();
  after.extent = after.displacement().norm();
  return {before, after};
}

}  // namespace

LeavingUnits find_leaving_units(const HandRecord& hand, std::vector<MovementUnit> units) {
  LeavingUnits result{std::move(units), {}};
  result.leaves.assign(result.units.size(), false);
  std::vector<FreeUnits> all = free_units(hand, result.units);
  std::ranges::reverse(all);  // a division moves later units only
  for (const FreeUnits& free : all) {
    if (!is_new_grasp(hand.signals, result.units, free) || goes_home(hand, result.units, free))
      continue;
    const auto leaving = result.units.begin() + free.first;
    if (free.end == free.first + 1) {
      const auto [before, after] =
          divide(hand.signals, *leaving, farthest_frame(hand.signals, *leaving, free));
      *leaving = before;
      result.units.insert(leaving + 1, after);
      result.leaves.insert(result.leaves.begin() + free.first + 1, false);
    }
    result.leaves[free.first] = true;
  }
  return result;
}

}  // namespace morphe::segment
