#include "stages/segment/segment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "stages/segment/cycles.hpp"
#include "stages/segment/grasp.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_units.hpp"

namespace morphe::segment {
namespace {

double share_seen(const HandSignals& signals, double begin_s, double end_s) {
  const std::size_t first = signals.frame(begin_s), last = signals.frame(end_s);
  std::size_t count = 0;
  for (std::size_t i = first; i <= last; ++i) count += signals.seen[i] ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(last - first + 1);
}

void add_phase(const HandSignals& signals, PhaseKind kind, double begin_s, double end_s,
               double begin_confidence, double end_confidence, Movement& movement) {
  if (end_s - begin_s < 0.5 * signals.step_s) return;
  const double seen = share_seen(signals, begin_s, end_s);
  movement.phases.push_back({kind, begin_s, end_s, 0.5 * (begin_confidence + end_confidence) * seen,
                             begin_confidence, end_confidence});
}

void set_planned_interval(const SegmentOptions& options, Movement& movement) {
  const Phase& reach = movement.phases.front();
  movement.begin_s = reach.begin_s;
  const Phase* until = last_phase(movement, options.plan_until);
  if (!until) until = last_phase(movement, PhaseKind::grasp);
  if (until) {
    movement.end_s = until->end_s;
    return;
  }
  movement.end_s = reach.end_s;
  for (const Phase& phase : movement.phases) {
    if (phase.kind != PhaseKind::hold || phase.begin_s > reach.end_s + 1e-9) continue;
    movement.end_s = std::min(phase.end_s, reach.end_s + options.hold_after_touch_s);
  }
}

/// Returns the index of the first unit after the grasp that is part of the return: the unit that
/// comes home, or those after the last one that carries a recorded object, or the last unit if it
/// heads home as the recording ends.
std::size_t first_return(const std::vector<MovementUnit>& bouts,
                         const std::vector<ObjectMotion>& motions, bool comes_home, bool moved,
                         const Vec3& home) {
  if (bouts.empty()) return 0;
  std::size_t back = bouts.size();
  if (moved) {
    while (back > 0 && !is_transport(bouts[back - 1], motions)) --back;
    return back;
  }
  const MovementUnit& last = bouts.back();
  const bool heads_home = last.end_truncated && (last.end_position - home).norm() <
                                                    0.5 * (last.start_position - home).norm();
  return comes_home || heads_home ? back - 1 : back;
}

/// Adds the phases of the units after the reach (and its grasp), with the pauses between them.
void add_later_phases(const HandSignals& signals, const std::vector<MovementUnit>& bouts,
                      std::size_t first_back, const GraspTimes& grasp, bool comes_home,
                      Movement& movement) {
  double from_s = grasp.end_s, from_confidence = grasp.end_confidence;
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const MovementUnit& bout = bouts[k];
    if (bout.end_s <= from_s) continue;
    add_phase(signals, PhaseKind::hold, from_s, bout.begin_s, from_confidence,
              bout.begin_confidence, movement);
    const PhaseKind out = grasp.grasped ? PhaseKind::transport : PhaseKind::reach;
    add_phase(signals, k >= first_back ? PhaseKind::return_phase : out,
              std::max(from_s, bout.begin_s), bout.end_s, bout.begin_confidence,
              bout.end_confidence, movement);
    from_s = bout.end_s;
    from_confidence = bout.end_confidence;
  }
  if (!comes_home && first_back >= bouts.size()) {
    add_phase(signals, PhaseKind::hold, from_s, signals.end_s(), from_confidence, 0, movement);
  }
}

Movement make_movement(const HandSignals& signals, const SegmentOptions& options,
                       const std::vector<ObjectMotion>& motions,
                       const std::vector<HandObjectInteraction>& contacts,
                       std::vector<MovementUnit> bouts, const std::vector<MovementUnit>& weak,
                       bool comes_home) {
  Movement movement;
  const GraspTimes grasp = find_grasp(signals, options, motions, contacts, bouts, weak, comes_home);
  movement.target = grasp.object;
  const MovementUnit reach = bouts.front();
  add_phase(signals, PhaseKind::reach, reach.begin_s, grasp.begin_s, reach.begin_confidence,
            grasp.begin_confidence, movement);
  if (movement.phases.empty()) return movement;
  if (grasp.grasped) {
    const double begin_s = std::clamp(grasp.opening.preshape_s, reach.begin_s, grasp.begin_s);
    add_phase(signals, PhaseKind::preshape, begin_s, grasp.begin_s, grasp.opening.confidence,
              grasp.begin_confidence, movement);
    add_phase(signals, PhaseKind::grasp, grasp.begin_s, grasp.end_s, grasp.begin_confidence,
              grasp.end_confidence, movement);
  }
  bouts.erase(bouts.begin(), bouts.begin() + grasp.units_used);
  if (grasp.grasped && !bouts.empty()) bouts.front().begin_s = grasp.end_s;
  const std::size_t back =
      first_return(bouts, motions, comes_home, grasp.object_moved, reach.start_position);
  add_later_phases(signals, bouts, back, grasp, comes_home, movement);
  return movement;
}

std::vector<Movement> whole_recording(const HumanMotion& motion) {
  Movement movement;
  bool any = false;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    bool hand = is_known(motion.wrist[i]);
    for (std::size_t finger = 0; finger < motion.tip.cols; ++finger) {
      hand = hand || is_known(motion.tip(i, finger));
    }
    if (!hand) continue;
    if (!any) movement.begin_s = motion.time[i];
    movement.end_s = motion.time[i];
    any = true;
  }
  return any ? std::vector<Movement>{movement} : std::vector<Movement>{};
}

}  // namespace

std::string validation_error(const SegmentOptions& o) {
  const std::pair<const char*, double> shares[] = {
      {"onset_share", o.onset_share},     {"weak_bout_share", o.weak_bout_share},
      {"dip_share", o.dip_share},         {"opening_share", o.opening_share},
      {"closing_share", o.closing_share}, {"preshape_share", o.preshape_share}};
  for (const auto& [name, value] : shares) {
    if (value < 0 || value >= 1) return fmt::format("{}: must be in [0, 1), not {}", name, value);
  }
  const std::pair<const char*, double> lengths[] = {
      {"velocity_smoothing_s", o.velocity_smoothing_s},
      {"min_peak_speed", o.min_peak_speed},
      {"min_reach_distance", o.min_reach_distance},
      {"return_radius", o.return_radius},
      {"min_grasp_s", o.min_grasp_s},
      {"min_object_displacement", o.min_object_displacement},
      {"hold_after_touch_s", o.hold_after_touch_s}};
  for (const auto& [name, value] : lengths) {
    if (value < 0) return fmt::format("{}: must not be negative, not {}", name, value);
  }
  if (o.onset_share == 0) return "onset_share: must be above 0";
  if (o.dip_share == 0) return "dip_share: must be above 0";
  if (o.min_peak_speed == 0) return "min_peak_speed: must be above 0";
  if (o.plan_until != PhaseKind::grasp && o.plan_until != PhaseKind::transport &&
      o.plan_until != PhaseKind::return_phase) {
    return fmt::format("plan_until: must be grasp, transport or return, not '{}'",
                       name_of(o.plan_until));
  }
  return "";
}

std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects) {
  if (options.whole_recording) return whole_recording(motion);
  const HandSignals signals = hand_signals(motion, options.velocity_smoothing_s);
  const std::vector<HandObjectInteraction> contacts = find_interactions(motion, signals, objects);
  const std::vector<ObjectMotion> motions =
      motions_by_hand(object_motions(objects, options.min_object_displacement), contacts, signals);
  std::vector<double> splits_s;
  for (const ObjectMotion& object : motions) {
    splits_s.insert(splits_s.end(), {object.begin_s, object.end_s});
  }
  std::vector<MovementUnit> bouts = find_movement_units(signals, options, splits_s), weak;
  std::copy_if(bouts.begin(), bouts.end(), std::back_inserter(weak),
               [](const MovementUnit& bout) { return bout.weak; });
  std::erase_if(bouts, [](const MovementUnit& bout) { return bout.weak; });
  std::vector<Movement> movements;
  for (const Cycle& cycle :
       find_cycles(signals, motion, options, bouts, objects, motions, contacts)) {
    const auto begin = bouts.begin() + cycle.first;
    Movement movement = make_movement(signals, options, motions, contacts,
                                      {begin, begin + cycle.count}, weak, cycle.returns_home);
    if (movement.phases.empty()) continue;
    movement.index = static_cast<int>(movements.size());
    set_planned_interval(options, movement);
    movements.push_back(std::move(movement));
  }
  return movements;
}

}  // namespace morphe::segment
