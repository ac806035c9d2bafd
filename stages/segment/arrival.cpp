#include "stages/segment/arrival.hpp"

#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

/// Returns the first frame from `from` to `last` at which the speed is below (or not below)
/// `level`; last + 1 if there is none.
int first_frame(const HandSignals& signals, int from, int last, double level, bool below) {
  int i = from;
  while (i <= last && (signals.speed[i] < level) != below) ++i;
  return i;
}

/// Returns the frame at which the hand arrives in a unit; the end of the unit if it does not go on.
int arrival_frame(const HandSignals& signals, const MovementUnit& unit) {
  const double peak = signals.speed[unit.peak];
  int arrival = first_frame(signals, unit.peak, unit.last, kArrivalShare * peak, true);
  const int goes_on = first_frame(signals, arrival, unit.last, kOccupiedShare * peak, false);
  if (goes_on > unit.last || goes_on - arrival < signals.frames_in(kMinOccupied_s))
    return unit.last;
  while (signals.speed[arrival + 1] < signals.speed[arrival]) ++arrival;
  return arrival;
}

MovementUnit part_of(const HandSignals& signals, const SegmentOptions& options, int first,
                     int last) {
  MovementUnit part;
  part.first = first;
  part.last = last;
  part.peak = part.first_peak = part.last_peak = fastest_frame(signals, first, last);
  find_boundaries(signals, options, part);
  return part;
}

}  // namespace

bool split_at_arrival(const HandSignals& signals, const SegmentOptions& options,
                      std::vector<MovementUnit>& units) {
  const MovementUnit whole = units.front();
  const int arrival = arrival_frame(signals, whole);
  if (arrival >= whole.last) return false;
  MovementUnit reach = part_of(signals, options, whole.first, arrival);
  if (reach.displacement().norm() < options.min_reach_distance) return false;
  reach.begin_s = whole.begin_s;
  reach.begin_confidence = whole.begin_confidence;
  MovementUnit rest = part_of(signals, options, arrival, whole.last);
  rest.begin_s = reach.end_s;
  rest.end_s = whole.end_s;
  rest.end_confidence = whole.end_confidence;
  units.front() = rest;
  units.insert(units.begin(), reach);
  return true;
}

}  // namespace morphe::segment
