#include "stages/segment/grasp.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::segment {
namespace {

constexpr double kLonelyGrasp_s = 0.3;
constexpr double kClosing_s = 0.1;  ///< the hand may close this much after it has arrived

const ObjectMotion* first_motion(const std::vector<ObjectMotion>& motions,
                                 const HandSignals& signals, const std::vector<Bout>& bouts) {
  const double from_s = signals.time(static_cast<double>(bouts.front().peak));
  for (const ObjectMotion& motion : motions) {
    if (motion.begin_s > from_s && motion.begin_s < bouts.back().end_s) return &motion;
  }
  return nullptr;
}

/// The bout in which an object that starts to move at `time_s` is carried.
std::size_t lifting_bout(const std::vector<Bout>& bouts, double time_s) {
  std::size_t lift = 1;
  while (lift < bouts.size() && bouts[lift].end_s <= time_s) ++lift;
  return lift;
}

/// Whether a bout after a pause still leads to the target: in the pause the hand has closed by less
/// than half of what it has closed by when the bout is over, and the wrist goes on as the tip does
/// (it would stay if the tip only moved to close the hand).
bool goes_on_reaching(const HandSignals& signals, const SegmentOptions& options, const Bout& reach,
                      const Bout& bout) {
  const double closed_s = bout.end_s + kClosing_s;
  if (!opening_in(signals, options, reach.begin_s, bout.begin_s, closed_s).grasps()) return false;
  const auto at = [&](double time_s) {
    return signals.opening.begin() + static_cast<std::ptrdiff_t>(signals.frame(time_s));
  };
  const auto widest = std::max_element(at(reach.begin_s), at(bout.end_s) + 1);
  const double closed = *widest - *std::min_element(widest, at(closed_s) + 1);
  const Vec3 wrist =
      signals.wrist[signals.frame(bout.end_s)] - signals.wrist[signals.frame(bout.begin_s)];
  const Vec3 way = reach.to - reach.from;
  return *widest - *at(bout.begin_s) < 0.5 * closed && wrist.dot(way) > 0 &&
         wrist.norm() > kWithWrist * (bout.to - bout.from).norm();
}

void last_at_least(double least_s, double from_s, double to_s, GraspTimes& grasp) {
  const double missing_s = least_s - (grasp.end_s - grasp.begin_s);
  if (missing_s <= 0) return;
  grasp.begin_s = std::max(from_s, grasp.begin_s - missing_s / 2);
  grasp.end_s = std::min(to_s, grasp.begin_s + least_s);
}

}  // namespace

GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<ObjectMotion>& motions,
                      const std::vector<Contact>& contacts, const std::vector<Bout>& bouts,
                      const std::vector<Bout>& weak, bool comes_home) {
  GraspTimes grasp;
  const ObjectMotion* moved = first_motion(motions, signals, bouts);
  std::size_t next = 1;
  if (moved) {
    grasp.moved = true;
    grasp.object = moved->object;
    next = lifting_bout(bouts, moved->begin_s);
  } else {
    while (next + (comes_home ? 1 : 0) < bouts.size() &&
           goes_on_reaching(signals, options, bouts.front(), bouts[next])) {
      ++next;
    }
  }
  std::size_t last = next - 1;
  while (last > 0 && moved && bouts[last].extent < options.least_reach &&
         !goes_on_reaching(signals, options, bouts.front(), bouts[last])) {
    --last;
  }
  Bout reach = bouts.front();
  for (std::size_t k = 1; k <= last; ++k) absorb(signals, options, bouts[k], reach);
  for (const Bout& bout : weak) {
    if (bout.begin_s < reach.end_s || (next < bouts.size() && bout.end_s > bouts[next].begin_s)) {
      continue;
    }
    if (goes_on_reaching(signals, options, reach, bout)) absorb(signals, options, bout, reach);
  }
  const bool alone = next >= bouts.size();
  grasp.bouts_used = next;
  grasp.begin_s = reach.end_s;
  grasp.begin_confidence = reach.end_confidence;
  if (alone) {
    grasp.end_s = moved ? std::max(grasp.begin_s, moved->begin_s) : grasp.begin_s + kLonelyGrasp_s;
    grasp.end_s = std::min(signals.end_s(), grasp.end_s);
    grasp.end_confidence = grasp.begin_confidence;
  } else {
    grasp.end_s = bouts[next].begin_s;
    grasp.end_confidence = bouts[next].begin_confidence;
  }
  const double begin_s = bouts.front().begin_s;
  grasp.opening = opening_in(signals, options, begin_s, grasp.begin_s, grasp.end_s);
  if (moved && !grasp.opening.widens) {
    grasp.opening.preshape_s = signals.time(static_cast<double>(bouts.front().peak));
  }
  if (!moved) {
    grasp.object = held_between(contacts, signals, grasp.begin_s, grasp.end_s, options.least_grasp);
    if (!grasp.object.empty() && !grasp.opening.widens) {
      grasp.opening.preshape_s = signals.time(static_cast<double>(bouts.front().peak));
    }
  }
  grasp.found = !grasp.object.empty() || grasp.opening.grasps();
  if (!grasp.found) {
    grasp.end_s = grasp.begin_s;
    grasp.end_confidence = grasp.begin_confidence;
    return grasp;
  }
  last_at_least(options.least_grasp, begin_s, signals.end_s(), grasp);
  return grasp;
}

}  // namespace morphe::segment
