#include "stages/segment/grasp.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::segment {
namespace {

constexpr double kDefaultGraspDuration_s = 0.3;
constexpr double kClosingDelay_s = 0.1;  ///< time after arrival in which the hand may still close
/// Largest displacement of the wrist relative to the object's once it is taken.
constexpr double kMaxWristObjectRatio = 2;

const ObjectMotion* first_motion(const std::vector<ObjectMotion>& motions,
                                 const HandSignals& signals,
                                 const std::vector<MovementUnit>& bouts) {
  const double from_s = signals.time(static_cast<double>(bouts.front().peak));
  for (const ObjectMotion& motion : motions) {
    if (motion.begin_s > from_s && motion.begin_s < bouts.back().end_s) return &motion;
  }
  return nullptr;
}

/// Returns the index of the unit in which an object that starts to move at `time_s` is carried.
std::size_t transport_unit(const std::vector<MovementUnit>& bouts, double time_s) {
  std::size_t lift = 1;
  while (lift < bouts.size() && bouts[lift].end_s <= time_s) ++lift;
  return lift;
}

/// Returns true if a unit after a pause still leads to the target: during the pause the hand has
/// closed by less than half of its closing at the end of the unit, and the wrist moves along with
/// the tip (it would stay if the tip only moved to close the hand).
bool continues_reach(const HandSignals& signals, const SegmentOptions& options,
                     const MovementUnit& reach, const MovementUnit& bout) {
  const double closed_s = bout.end_s + kClosingDelay_s;
  if (!measure_aperture(signals, options, reach.begin_s, bout.begin_s, closed_s).grasps())
    return false;
  const auto at = [&](double time_s) { return signals.aperture.begin() + signals.frame(time_s); };
  const auto widest = std::max_element(at(reach.begin_s), at(bout.end_s) + 1);
  const double closed = *widest - *std::min_element(widest, at(closed_s) + 1);
  const Vec3 wrist =
      signals.wrist[signals.frame(bout.end_s)] - signals.wrist[signals.frame(bout.begin_s)];
  const Vec3 way = reach.end_position - reach.start_position;
  return *widest - *at(bout.begin_s) < 0.5 * closed && wrist.dot(way) > 0 &&
         wrist.norm() > kMinWristShare * (bout.end_position - bout.start_position).norm();
}

/// Returns the time at which the hand that sets out at `out_s` has the object: from there on the
/// wrist travels no farther than kMaxWristObjectRatio times the object's displacement until the
/// object is seen to move. A hand that pauses before it arrives travels farther.
double grasp_completion_time(const HandSignals& signals, const ObjectMotion& motion,
                             double object_way, double out_s) {
  const std::size_t seen = signals.frame(motion.begin_s);
  const double way = kMaxWristObjectRatio * object_way;
  double nearer = 0;
  for (std::size_t i = seen; i > 0 && signals.time(static_cast<double>(i)) > out_s; --i) {
    const double farther = (signals.wrist[i - 1] - signals.wrist[seen]).norm();
    if (farther > way) {
      const double share = (farther - way) / (farther - nearer);
      return std::max(out_s, signals.time(static_cast<double>(i - 1) + share));
    }
    nearer = farther;
  }
  return out_s;
}

void enforce_min_duration(double least_s, double from_s, double to_s, GraspTimes& grasp) {
  const double missing_s = least_s - (grasp.end_s - grasp.begin_s);
  if (missing_s <= 0) return;
  grasp.begin_s = std::max(from_s, grasp.begin_s - missing_s / 2);
  grasp.end_s = std::min(to_s, grasp.begin_s + least_s);
}

}  // namespace

GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<ObjectMotion>& motions,
                      const std::vector<HandObjectInteraction>& contacts,
                      const std::vector<MovementUnit>& bouts, const std::vector<MovementUnit>& weak,
                      bool comes_home) {
  GraspTimes grasp;
  const ObjectMotion* moved = first_motion(motions, signals, bouts);
  std::size_t next = 1;
  if (moved) {
    grasp.object_moved = true;
    grasp.object = moved->object;
    next = transport_unit(bouts, moved->begin_s);
  } else {
    while (next + (comes_home ? 1 : 0) < bouts.size() &&
           continues_reach(signals, options, bouts.front(), bouts[next])) {
      ++next;
    }
  }
  std::size_t last = next - 1;
  while (last > 0 && moved && bouts[last].extent < options.min_reach_distance &&
         !continues_reach(signals, options, bouts.front(), bouts[last])) {
    --last;
  }
  MovementUnit reach = bouts.front();
  for (std::size_t k = 1; k <= last; ++k) merge_unit(signals, options, bouts[k], reach);
  for (const MovementUnit& bout : weak) {
    if (bout.begin_s < reach.end_s || (next < bouts.size() && bout.end_s > bouts[next].begin_s)) {
      continue;
    }
    if (continues_reach(signals, options, reach, bout)) merge_unit(signals, options, bout, reach);
  }
  const bool alone = next >= bouts.size();
  grasp.units_used = next;
  grasp.begin_s = reach.end_s;
  grasp.begin_confidence = reach.end_confidence;
  if (alone) {
    grasp.end_s =
        moved ? std::max(grasp.begin_s, moved->begin_s) : grasp.begin_s + kDefaultGraspDuration_s;
    grasp.end_s = std::min(signals.end_s(), grasp.end_s);
    grasp.end_confidence = grasp.begin_confidence;
  } else {
    grasp.end_s = bouts[next].begin_s;
    grasp.end_confidence = bouts[next].begin_confidence;
  }
  if (moved && !alone && options.until_grasped) {
    const double later_s =
        grasp_completion_time(signals, *moved, options.min_object_displacement, grasp.end_s) -
        grasp.end_s;
    grasp.begin_s += later_s;
    grasp.end_s += later_s;
  }
  const double begin_s = bouts.front().begin_s;
  grasp.opening = measure_aperture(signals, options, begin_s, grasp.begin_s, grasp.end_s);
  if (moved && !grasp.opening.widens) {
    grasp.opening.preshape_s = signals.time(static_cast<double>(bouts.front().peak));
  }
  if (!moved) {
    grasp.object =
        longest_held_object(contacts, signals, grasp.begin_s, grasp.end_s, options.min_grasp_s);
    if (!grasp.object.empty() && !grasp.opening.widens) {
      grasp.opening.preshape_s = signals.time(static_cast<double>(bouts.front().peak));
    }
  }
  grasp.grasped = !grasp.object.empty() || grasp.opening.grasps();
  if (!grasp.grasped) {
    grasp.end_s = grasp.begin_s;
    grasp.end_confidence = grasp.begin_confidence;
    return grasp;
  }
  enforce_min_duration(options.min_grasp_s, begin_s, signals.end_s(), grasp);
  return grasp;
}

}  // namespace morphe::segment
