#include "stages/segment/grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe {
namespace {

struct ObjectMotion {
  double time_s = std::numeric_limits<double>::infinity();
  std::string name;
};

/// The first recorded object to move away from where it was at the peak of the reach. The time is
/// not traced back to the first stir: a hand that closes pushes an object by a millimetre or two.
ObjectMotion first_object_motion(const HandSignals& signals, double distance_m,
                                 const std::vector<SceneObject>& objects,
                                 const std::vector<Bout>& bouts) {
  ObjectMotion first;
  const double from_s = signals.time(static_cast<double>(bouts.front().peak));
  for (const SceneObject& object : objects) {
    if (object.time.size() < 2) continue;
    const Vec3 rest = recorded_pose(object, from_s).translation();
    for (std::size_t i = 0; i < object.time.size(); ++i) {
      const double at_s = object.time[i];
      if (at_s < from_s || at_s > bouts.back().end_s || at_s >= first.time_s) continue;
      if ((object.position[i] - rest).norm() > distance_m) first = {at_s, object.name};
    }
  }
  return first;
}

double path_extent(const HandSignals& signals, const Bout& bout) {
  const std::size_t end = signals.frame(bout.end_s);
  return (signals.position[end] - signals.position[signals.frame(bout.begin_s)]).norm();
}

/// Reach and grasp when the transport is known to begin at `motion.time_s`.
void end_at_object(const HandSignals& signals, const SegmentOptions& options,
                   const ObjectMotion& motion, std::vector<Bout>& bouts, GraspTimes& grasp) {
  const double lift_s = motion.time_s;
  std::size_t reach = 0;
  for (std::size_t k = 1; k < bouts.size() && bouts[k].end_s < lift_s; ++k) {
    if (path_extent(signals, bouts[k]) > options.least_reach) reach = k;
  }
  const Bout& last_reach = bouts[reach];
  grasp.begin_s = last_reach.end_s;
  grasp.begin_confidence = last_reach.end_confidence;
  if (last_reach.end_s >= lift_s) {
    const auto begin = signals.speed.begin();
    const std::size_t lift = std::max(signals.frame(lift_s), last_reach.peak + 1);
    const auto slowest =
        std::min_element(begin + static_cast<std::ptrdiff_t>(last_reach.peak),
                         begin + static_cast<std::ptrdiff_t>(std::min(lift, last_reach.last)) + 1);
    grasp.begin_s = std::min(lift_s, signals.time(static_cast<double>(slowest - begin)));
    grasp.begin_confidence = boundary_confidence(*slowest, signals.speed[last_reach.peak], 1.0);
  }
  // The transport: the bout in which the object moves, or from there on what is left of it.
  std::size_t next = reach;
  while (next < bouts.size() && bouts[next].end_s <= lift_s) ++next;
  grasp.end_s = lift_s;
  grasp.bouts_used = next;
}

/// Whether the opening widened in the reach and closed again by the transport; where it began to.
void judge_opening(const HandSignals& signals, const SegmentOptions& options, double reach_begin_s,
                   double closed_by_s, GraspTimes& grasp, bool& widens, bool& closes) {
  widens = closes = false;
  grasp.preshape_s = reach_begin_s;
  if (signals.opening.empty()) return;
  const std::vector<double>& opening = signals.opening;
  const std::size_t first = signals.frame(reach_begin_s), end = signals.frame(grasp.begin_s);
  const std::size_t closed = std::max(end, signals.frame(closed_by_s));
  const auto at = [&](std::size_t i) { return opening.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto widest = std::max_element(at(first), at(end) + 1);
  const double rise = *widest - opening[first];
  widens = rise > options.widening_share * opening[first];
  closes = *widest - *std::min_element(widest, at(closed) + 1) > options.closing_share * rise;
  if (!(rise > 0)) return;
  std::size_t opens = first;
  while (opens < end && opening[opens] < opening[first] + options.preshape_share * rise) ++opens;
  grasp.preshape_s = signals.time(static_cast<double>(opens));
  grasp.opening_confidence =
      std::clamp(rise / (2 * options.widening_share * opening[first]), 0.0, 1.0);
}

/// Without a pause the grasp is a short interval around the slowest point.
void last_at_least(double least_s, double reach_begin_s, double recording_end_s,
                   GraspTimes& grasp) {
  const double missing_s = least_s - (grasp.end_s - grasp.begin_s);
  if (missing_s <= 0) return;
  grasp.begin_s = std::max(reach_begin_s, grasp.begin_s - missing_s / 2);
  grasp.end_s = std::min(recording_end_s, grasp.begin_s + least_s);
}

}  // namespace

GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<SceneObject>& objects, std::vector<Bout>& bouts) {
  GraspTimes grasp;
  const double recording_end_s = signals.time(static_cast<double>(signals.frames() - 1));
  const ObjectMotion motion = first_object_motion(signals, options.object_motion, objects, bouts);
  bool widens = false, closes = false;
  if (std::isfinite(motion.time_s)) {
    grasp.found = true;
    grasp.object = motion.name;
    end_at_object(signals, options, motion, bouts, grasp);
    last_at_least(options.least_grasp, bouts.front().begin_s, recording_end_s, grasp);
    judge_opening(signals, options, bouts.front().begin_s, grasp.end_s, grasp, widens, closes);
    if (!widens) grasp.preshape_s = signals.time(static_cast<double>(bouts.front().peak));
    return grasp;
  }
  const Bout& reach = bouts.front();
  const bool alone = bouts.size() < 2;
  grasp.begin_s = reach.end_s;
  grasp.end_s = alone ? std::min(recording_end_s, reach.end_s + 0.3) : bouts[1].begin_s;
  grasp.begin_confidence = reach.end_confidence;
  grasp.end_confidence = alone ? reach.end_confidence : bouts[1].begin_confidence;
  judge_opening(signals, options, reach.begin_s, grasp.end_s, grasp, widens, closes);
  grasp.found = widens && closes;
  if (!grasp.found) {
    grasp.end_s = grasp.begin_s;
    grasp.end_confidence = grasp.begin_confidence;
    return grasp;
  }
  last_at_least(options.least_grasp, reach.begin_s, recording_end_s, grasp);
  return grasp;
}

}  // namespace morphe
