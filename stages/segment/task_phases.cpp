#include "stages/segment/task_phases.hpp"

#include <algorithm>

#include "core/motion/bounding_box.hpp"
#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

/// Returns the height of what the hand carries at a frame, up to a constant [m].
double carried_height(const HandRecord& hand, const Movement& movement, int frame) {
  const bool moved =
      std::ranges::find(hand.motions, movement.target, &ObjectMotion::object) != hand.motions.end();
  const SceneObject* target = moved ? find_object(hand.objects, movement.target) : nullptr;
  if (!target) return hand.signals.position[frame].z();
  const Pose pose = recorded_pose(*target, hand.signals.time(frame));
  const double lowest = bounding_box(*target, pose).min().z();
  return std::isfinite(lowest) ? lowest : pose.translation().z();
}

/// Returns the first frame of first … last with a property, else `last`.
template <class Property>
int first_frame(int first, int last, const Property& has) {
  while (first < last && !has(first)) ++first;
  return first;
}

void add_lift(const HandRecord& hand, const Phase& transport, Movement& movement) {
  const HandSignals& signals = hand.signals;
  const int begin = signals.frame(transport.begin_s), end = signals.frame(transport.end_s);
  const double support = carried_height(hand, movement, begin);
  const int lifted = first_frame(begin, end + 1, [&](int frame) {
    return carried_height(hand, movement, frame) > support + kLiftHeight_m;
  });
  if (lifted > end) return;
  Phase lift = transport;
  lift.kind = PhaseKind::lift;
  lift.end_s = std::min(signals.time(lifted), transport.end_s);
  add_phase(signals, lift, movement);
}

void add_place(const HandRecord& hand, const Phase& transport, Movement& movement) {
  const HandSignals& signals = hand.signals;
  const int begin = signals.frame(transport.begin_s), end = signals.frame(transport.end_s);
  const double support = carried_height(hand, movement, end);
  int low = end;
  while (low >= begin && carried_height(hand, movement, low) <= support + kLiftHeight_m) --low;
  if (low < begin) return;
  Phase place = transport;
  place.kind = PhaseKind::place;
  place.begin_s = std::max(signals.time(low), transport.begin_s);
  add_phase(signals, place, movement);
}

/// Adds the phases of the hand that leaves the target, from the end of the transport to `back`.
void add_leaving(const HandSignals& signals, const Phase& transport, const Phase& back,
                 bool goes_on, Movement& movement) {
  const int first = signals.frame(transport.end_s), last = signals.frame(back.end_s);
  const Vec3 start = signals.wrist[first];
  double begin_s = transport.end_s, begin_confidence = transport.end_confidence;
  const auto add = [&](PhaseKind kind, double end_s) {
    end_s = std::clamp(end_s, begin_s, back.end_s);
    add_phase(signals, {kind, begin_s, end_s, 1, begin_confidence, back.end_confidence}, movement);
    begin_s = end_s;
    begin_confidence = back.begin_confidence;
  };
  const auto left_s = [&](double distance_m) {
    return signals.time(first_frame(first, last, [&](int frame) {
      return (signals.wrist[frame] - start).norm() > distance_m;
    }));
  };
  add(PhaseKind::release, left_s(kReleaseDistance_m));
  add(PhaseKind::retreat, goes_on ? back.end_s : left_s(kMaxHandDistance_m));
  add(PhaseKind::home, back.end_s);
}

}  // namespace

void add_phase(const HandSignals& signals, const Phase& phase, Movement& movement) {
  if (phase.end_s - phase.begin_s < 0.5 * signals.step_s) return;
  const int first = signals.frame(phase.begin_s), end = signals.frame(phase.end_s) + 1;
  const auto flag = signals.seen.begin();
  const double seen =
      static_cast<double>(std::count(flag + first, flag + end, true)) / (end - first);
  movement.phases.push_back(phase);
  movement.phases.back().confidence = 0.5 * (phase.begin_confidence + phase.end_confidence) * seen;
}

void add_task_phases(const HandRecord& hand, bool goes_on, Movement& movement) {
  const auto first = std::ranges::find(movement.phases, PhaseKind::transport, &Phase::kind);
  if (first == movement.phases.end()) return;
  const Phase first_transport = *first;
  const Phase last_transport = *last_phase(movement, PhaseKind::transport);
  add_lift(hand, first_transport, movement);
  if (!is_put_down(movement)) return;
  add_place(hand, last_transport, movement);
  add_leaving(hand.signals, last_transport, Phase(*last_phase(movement, PhaseKind::return_phase)),
              goes_on, movement);
}

}  // namespace morphe::segment
