#include "stages/segment/grasp.hpp"

#include <algorithm>

#include "stages/segment/constants.hpp"
#include "stages/segment/grasp_place.hpp"

namespace morphe::segment {
namespace {

/// Returns the first object motion that begins after the peak of the first unit and before the end
/// of the last one, or null.
const ObjectMotion* first_motion(const std::vector<ObjectMotion>& motions,
                                 const HandSignals& signals,
                                 const std::vector<MovementUnit>& units) {
  const double peak_s = signals.time(units.front().peak);
  for (const ObjectMotion& motion : motions) {
    if (motion.begin_s > peak_s && motion.begin_s < units.back().end_s) return &motion;
  }
  return nullptr;
}

/// Returns true if a unit after a pause still leads to the target. By its begin, the hand has
/// closed by less than half of the closing at its end, and in the unit the wrist moves on with the
/// tip (it would stay if the tip only moved to close the hand).
bool continues_reach(const HandSignals& signals, const SegmentOptions& options,
                     const MovementUnit& reach, const MovementUnit& unit) {
  const double closed_s = unit.end_s + kClosingDelay_s;
  if (!measure_aperture(signals, options, reach.begin_s, unit.begin_s, closed_s).grasps())
    return false;
  const int begin = signals.frame(unit.begin_s), end = signals.frame(unit.end_s);
  const auto aperture = signals.aperture.begin();
  const auto widest = std::max_element(aperture + signals.frame(reach.begin_s), aperture + end + 1);
  const double closing =
      *widest - *std::min_element(widest, aperture + signals.frame(closed_s) + 1);
  const Vec3 wrist = signals.wrist[end] - signals.wrist[begin];
  return *widest - aperture[begin] < kMaxPauseClosingShare * closing &&
         wrist.dot(reach.displacement()) > 0 &&
         wrist.norm() > kMinWristShare * unit.displacement().norm();
}

/// Returns the time, from `out_s` on, after which the wrist travels no farther than
/// kMaxWristObjectRatio · object_displacement_m until the object is seen to move. Then the hand has
/// the object; a hand that sets out at `out_s` from a pause before the object travels farther.
double grasp_completion_time(const HandSignals& signals, const ObjectMotion& motion,
                             double object_displacement_m, double out_s) {
  const int seen = signals.frame(motion.begin_s);
  const double limit_m = kMaxWristObjectRatio * object_displacement_m;
  double next_m = 0;  // displacement from the frame after the current one
  for (int i = seen - 1; i >= 0 && signals.time(i + 1) > out_s; --i) {
    const double displacement_m = (signals.wrist[i] - signals.wrist[seen]).norm();
    if (displacement_m > limit_m) {
      const double share = (displacement_m - limit_m) / (displacement_m - next_m);
      return std::max(out_s, signals.time(i + share));
    }
    next_m = displacement_m;
  }
  return out_s;
}

/// Returns the first unit that does not continue the reach.
int first_departure(const HandRecord& hand, const std::vector<MovementUnit>& units,
                    bool comes_home) {
  int next = 1;
  while (next + (comes_home ? 1 : 0) < std::ssize(units) &&
         continues_reach(hand.signals, hand.options, units.front(), units[next])) {
    ++next;
  }
  return next;
}

/// Returns true if the hand holds a recorded object before it sets out with unit `departure`.
bool holds_object(const HandRecord& hand, const std::vector<MovementUnit>& units, int departure) {
  const double next_s =
      departure < std::ssize(units) ? units[departure].begin_s : hand.signals.end_s();
  return !longest_held_object(hand.interactions, hand.signals, units[departure - 1].end_s, next_s,
                              hand.options.min_grasp_s)
              .empty();
}

/// Widens a shorter grasp at both ends, within earliest_s … latest_s.
void enforce_min_duration(double min_s, double earliest_s, double latest_s, GraspTimes& grasp) {
  const double missing_s = min_s - (grasp.end_s - grasp.begin_s);
  if (missing_s <= 0) return;
  grasp.begin_s = std::max(earliest_s, grasp.begin_s - missing_s / 2);
  grasp.end_s = std::min(latest_s, grasp.begin_s + min_s);
}

}  // namespace

GraspTimes find_grasp(const HandRecord& hand, const std::vector<MovementUnit>& units,
                      const std::vector<MovementUnit>& weak, bool comes_home) {
  const SegmentOptions& options = hand.options;
  const HandSignals& signals = hand.signals;
  GraspTimes grasp;
  GraspPlace place;
  bool held = false;  // a recorded object that does not move
  const ObjectMotion* moved = first_motion(hand.motions, signals, units);
  const std::ptrdiff_t count = std::ssize(units);
  int next = 1;  // the unit after the reach and the grasp
  if (moved) {
    grasp.object_moved = true;
    grasp.object = moved->object;
    while (next < count && units[next].end_s <= moved->begin_s) ++next;
  } else {
    next = first_departure(hand, units, comes_home);
    held = holds_object(hand, units, next);
    if (!held) place = find_place(hand, units, next, comes_home);
    if (!held) next = place.next;
    grasp.release_unit = place.come_back.score > 0 ? place.come_back.unit : -1;
  }
  int last = next - 1;  // of the reach
  while (last > 0 && moved && units[last].extent < options.min_reach_distance &&
         !continues_reach(signals, options, units.front(), units[last])) {
    --last;
  }
  MovementUnit reach = units.front();
  for (int k = 1; k <= last; ++k) merge_unit(signals, options, units[k], reach);
  const bool grasps = moved || held || place.evidence.log_odds() > 0;
  for (const MovementUnit& unit : weak) {
    const bool between = grasps && unit.begin_s >= reach.end_s &&
                         (next == count || unit.end_s <= units[next].begin_s);
    if (between && continues_reach(signals, options, reach, unit))
      merge_unit(signals, options, unit, reach);
  }
  grasp.units_used = next;
  grasp.begin_s = reach.end_s;
  grasp.begin_confidence = grasp.end_confidence = reach.end_confidence;
  if (next < count) {
    grasp.end_s = units[next].begin_s;
    grasp.end_confidence = units[next].begin_confidence;
  } else {
    grasp.end_s =
        moved ? std::max(grasp.begin_s, moved->begin_s) : grasp.begin_s + kDefaultGraspDuration_s;
    grasp.end_s = std::min(signals.end_s(), grasp.end_s);
  }
  if (moved && next < count && options.until_grasped) {
    const double delay_s =
        grasp_completion_time(signals, *moved, options.min_object_displacement, grasp.end_s) -
        grasp.end_s;
    grasp.begin_s += delay_s;
    grasp.end_s += delay_s;
  }
  const double begin_s = units.front().begin_s;
  grasp.aperture = measure_aperture(signals, options, begin_s, grasp.begin_s, grasp.end_s);
  if (!moved) {
    grasp.object = longest_held_object(hand.interactions, signals, grasp.begin_s, grasp.end_s,
                                       options.min_grasp_s);
  }
  if ((moved || !grasp.object.empty()) && !grasp.aperture.widens)
    grasp.aperture.preshape_s = signals.time(units.front().peak);
  if (!moved && grasp.object.empty()) grasp.probability = place.evidence.probability();
  grasp.grasped = grasp.probability > 0.5;
  if (!grasp.grasped) {
    grasp.end_s = grasp.begin_s;
    grasp.end_confidence = grasp.begin_confidence;
  } else {
    enforce_min_duration(options.min_grasp_s, begin_s, signals.end_s(), grasp);
  }
  return grasp;
}

}  // namespace morphe::segment
