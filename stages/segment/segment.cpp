#include "stages/segment/segment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/math/statistics.hpp"
#include "stages/segment/arrival.hpp"
#include "stages/segment/come_back.hpp"
#include "stages/segment/constants.hpp"
#include "stages/segment/cycles.hpp"
#include "stages/segment/grasp.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_units.hpp"
#include "stages/segment/next_grasp.hpp"
#include "stages/segment/task_phases.hpp"

namespace morphe::segment {
namespace {

/// Returns the last phase to be planned of a recording with this task.
PhaseKind plan_until(const SegmentOptions& options, std::string_view task) {
  const auto own = std::ranges::find_if(options.plan_until_by_task, [&](const TaskEnd& end) {
    return contains_word(task, end.task);
  });
  return own == options.plan_until_by_task.end() ? options.plan_until : own->until;
}

void set_planned_interval(const SegmentOptions& options, std::string_view task,
                          Movement& movement) {
  const Phase& reach = movement.phases.front();
  movement.begin_s = reach.begin_s;
  if (const Phase* last = planned_end(movement, plan_until(options, task))) {
    movement.end_s = last->end_s;
    return;
  }
  movement.end_s = reach.end_s;
  for (const Phase& phase : movement.phases) {
    if (phase.kind != PhaseKind::hold || phase.begin_s > reach.end_s + 1e-9) continue;
    movement.end_s = std::min(phase.end_s, reach.end_s + options.hold_after_touch_s);
  }
}

/// Returns the index of the first of `units`, those after the grasp, that belongs to the return;
/// their number if there is no return. If a recorded object was moved, the return begins after the
/// last unit that carries one. Otherwise it is the last unit, if that comes home or if it heads
/// home as the recording ends.
std::ptrdiff_t first_return(const std::vector<MovementUnit>& units,
                            const std::vector<ObjectMotion>& motions, bool comes_home, bool moved,
                            const Vec3& home) {
  if (units.empty()) return 0;
  std::ptrdiff_t back = std::ssize(units);
  if (moved) {
    while (back > 0 && !is_transport(units[back - 1], motions)) --back;
    return back;
  }
  const MovementUnit& last = units.back();
  const bool heads_home =
      last.end_truncated &&
      (last.end_position - home).norm() < kMaxHomingRatio * (last.start_position - home).norm();
  return comes_home || heads_home ? back - 1 : back;
}

/// Adds the phases of the units after the reach and its grasp, with the pauses between them. The
/// units from `first_back` on are the return.
void add_later_phases(const HandSignals& signals, const std::vector<MovementUnit>& units,
                      std::ptrdiff_t first_back, const GraspTimes& grasp, bool comes_home,
                      Movement& movement) {
  const auto add = [&](PhaseKind kind, double begin_s, double end_s, double begin_confidence,
                       double end_confidence) {
    add_phase(signals, {kind, begin_s, end_s, 1, begin_confidence, end_confidence}, movement);
  };
  double from_s = grasp.end_s, from_confidence = grasp.end_confidence;
  for (int k = 0; k < std::ssize(units); ++k) {
    const MovementUnit& unit = units[k];
    if (unit.end_s <= from_s) continue;
    add(PhaseKind::hold, from_s, unit.begin_s, from_confidence, unit.begin_confidence);
    const PhaseKind outward = grasp.grasped ? PhaseKind::transport : PhaseKind::reach;
    add(k >= first_back ? PhaseKind::return_phase : outward, std::max(from_s, unit.begin_s),
        unit.end_s, unit.begin_confidence, unit.end_confidence);
    from_s = unit.end_s;
    from_confidence = unit.end_confidence;
  }
  if (!comes_home && first_back >= std::ssize(units))
    add(PhaseKind::hold, from_s, signals.end_s(), from_confidence, 0);
}

/// Makes the movement of the `units` of one cycle, without index and planned interval; without
/// phases if its reach is shorter than half a frame.
Movement make_movement(const HandRecord& hand, std::vector<MovementUnit> units,
                       const std::vector<MovementUnit>& weak, const Cycle& cycle) {
  const HandSignals& signals = hand.signals;
  const bool comes_home = cycle.returns_home;
  Movement movement;
  GraspTimes grasp = find_grasp(hand, units, weak, comes_home);
  if (!grasp.grasped && split_at_arrival(signals, hand.options, units)) {
    grasp.begin_s = grasp.end_s = units.front().end_s;
    grasp.begin_confidence = grasp.end_confidence = units.front().end_confidence;
  }
  movement.target = grasp.object;
  const MovementUnit reach = units.front();
  add_phase(signals,
            {PhaseKind::reach, reach.begin_s, grasp.begin_s, 1, reach.begin_confidence,
             grasp.begin_confidence},
            movement);
  if (movement.phases.empty()) return movement;
  if (grasp.grasped) {
    const double begin_s = std::clamp(grasp.aperture.preshape_s, reach.begin_s, grasp.begin_s);
    add_phase(signals,
              {PhaseKind::preshape, begin_s, grasp.begin_s, 1, grasp.aperture.confidence,
               grasp.begin_confidence},
              movement);
    add_phase(signals,
              {PhaseKind::grasp, grasp.begin_s, grasp.end_s, 1, grasp.begin_confidence,
               grasp.end_confidence},
              movement);
    movement.phases.back().confidence *= grasp.probability;
  }
  units.erase(units.begin(), units.begin() + grasp.units_used);
  if (grasp.grasped && !units.empty()) units.front().begin_s = grasp.end_s;
  const std::ptrdiff_t back =
      grasp.grasped && comes_home && grasp.release_unit >= 0
          ? grasp.release_unit + 1 - grasp.units_used
          : first_return(units, hand.motions, comes_home, grasp.object_moved, reach.start_position);
  add_later_phases(signals, units, back, grasp, comes_home, movement);
  if (grasp.grasped) add_task_phases(hand, cycle.goes_on, movement);
  return movement;
}

/// Returns the length of upper arm and forearm; NaN if they were not seen.
double arm_length_m(const HumanMotion& motion) {
  const std::size_t n = motion.time.size();
  if (motion.shoulder.size() != n || motion.elbow.size() != n || motion.wrist.size() != n)
    return kUnknown;
  return math::median_distance(motion.shoulder, motion.elbow) +
         math::median_distance(motion.elbow, motion.wrist);
}

std::string end_error(std::string_view key, PhaseKind kind) {
  if (may_end_plan(kind)) return "";
  std::string names;
  for (std::size_t k = 0; k < enum_count<PhaseKind>(); ++k) {
    const auto own = static_cast<PhaseKind>(k);
    if (may_end_plan(own)) names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(own));
  }
  return fmt::format("{}: must be one of {}, not '{}'", key, names, name_of(kind));
}

std::string validation_error(const std::vector<TaskEnd>& ends) {
  for (const TaskEnd& end : ends) {
    if (end.task.empty()) return "plan_until_by_task: task must be a word";
    if (const std::string error = end_error("plan_until_by_task", end.until); !error.empty())
      return error;
  }
  return "";
}

std::vector<Movement> whole_recording(const HumanMotion& motion) {
  Movement movement;
  bool seen = false;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    bool hand = is_known(motion.wrist[i]);
    for (std::size_t finger = 0; finger < motion.tip.cols; ++finger)
      hand = hand || is_known(motion.tip(i, finger));
    if (!hand) continue;
    if (!seen) movement.begin_s = motion.time[i];
    movement.end_s = motion.time[i];
    seen = true;
  }
  return seen ? std::vector<Movement>{movement} : std::vector<Movement>{};
}

}  // namespace

std::string validation_error(const SegmentOptions& o) {
  const std::string error = end_error("plan_until", o.plan_until);
  return error.empty() ? validation_error(o.plan_until_by_task) : error;
}

std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects, std::string_view task) {
  if (options.whole_recording) return whole_recording(motion);
  HandRecord hand{motion, options, objects, kind_of_task(task),
                  hand_signals(motion, options.velocity_smoothing_s)};
  hand.shoulder = math::median_point(motion.shoulder);
  hand.arm_length_m = arm_length_m(motion);
  hand.interactions = find_interactions(motion, hand.signals, objects);
  hand.motions = motions_by_hand(object_motions(objects, options.min_object_displacement),
                                 hand.interactions, hand.signals);
  std::vector<double> splits_s = find_passing_turns(hand.signals, options);
  for (const ObjectMotion& object : hand.motions)
    splits_s.insert(splits_s.end(), {object.begin_s, object.end_s});
  std::vector<MovementUnit> units = find_movement_units(hand.signals, options, splits_s);
  const auto first_weak = std::stable_partition(
      units.begin(), units.end(), [](const MovementUnit& unit) { return !unit.weak; });
  const std::vector<MovementUnit> weak(first_weak, units.end());
  units.erase(first_weak, units.end());
  const LeavingUnits leaving = find_leaving_units(hand, std::move(units));
  std::vector<Movement> movements;
  for (const Cycle& cycle : find_cycles(hand, leaving.units, leaving.leaves)) {
    const auto begin = leaving.units.begin() + cycle.first;
    Movement movement = make_movement(hand, {begin, begin + cycle.count}, weak, cycle);
    if (movement.phases.empty()) continue;
    movement.index = movements.empty() ? 0 : movements.back().index + 1;
    set_planned_interval(options, task, movement);
    movements.push_back(std::move(movement));
  }
  return movements;
}

}  // namespace morphe::segment
