#include "pipeline/planning/partial_delivery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "stages/map/map_movement.hpp"

namespace morphe::planning {
namespace {

constexpr double kCutTolerance_s = 1e-9;

/// Returns true if the hand holds the target in the air at a time at which a phase ends.
bool is_in_air(const Movement& movement, double time_s) {
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  if (!grasp || !transport || time_s <= grasp->end_s + kCutTolerance_s) return false;
  return time_s < transport->end_s - kCutTolerance_s || !is_put_down(movement);
}

/// Returns true if a shorter plan may be executable: the movement was mapped, and it fails neither
/// at its begin nor because its trajectory is faulty.
bool may_hold_in_part(const Plan& failed) {
  return !failed.has_trajectory() && failed.mapped.position.rows() > 0 &&
         failed.reason != Reason::start_in_collision && failed.reason != Reason::no_approach;
}

Plan as_part(Plan part, const Phase& last, const Plan& whole) {
  const std::string notes = part.detail.empty() ? "" : "; of the part: " + part.detail;
  part.reason = whole.reason;
  part.detail = fmt::format("delivered until the end of {}, {:.2f} s of {:.2f} to {:.2f} s: {}{}",
                            name_of(last.kind), last.end_s, whole.movement.begin_s,
                            whole.movement.end_s, whole.detail, notes);
  part.delivered = {last.kind, whole.movement.end_s};
  return part;
}

}  // namespace

std::vector<Phase> permitted_cuts(const Movement& movement, PartialPlans partial) {
  std::vector<Phase> cuts;
  if (partial == PartialPlans::never) return cuts;
  const bool grasps = last_phase(movement, PhaseKind::grasp) != nullptr;
  for (const Phase& phase : movement.phases) {
    const bool ends_plan = grasps ? may_end_plan(phase.kind) : phase.kind == PhaseKind::reach;
    const bool inside = phase.end_s > movement.begin_s + kCutTolerance_s &&
                        phase.end_s < movement.end_s - kCutTolerance_s;
    if (!ends_plan || !inside || &phase != last_phase(movement, phase.kind)) continue;
    if (partial == PartialPlans::in_air || !is_in_air(movement, phase.end_s)) cuts.push_back(phase);
  }
  // Puts the phase that refines others first among those that end together.
  std::ranges::reverse(cuts);
  std::ranges::stable_sort(cuts, std::ranges::greater{}, &Phase::end_s);
  return cuts;
}

Plan plan_movement_or_part(const PlanningInputs& planner, const Demonstration& demonstration,
                           const HumanMotion& recorded, const Movement& movement) {
  Plan whole = plan_movement(planner, demonstration, recorded, movement);
  if (!may_hold_in_part(whole)) return whole;
  double tried_s = kInfinity;
  for (const Phase& last : permitted_cuts(movement, planner.config.segment.partial)) {
    if (last.end_s == tried_s) continue;
    Movement part = movement;
    part.end_s = tried_s = last.end_s;
    Plan plan = plan_movement(planner, demonstration, recorded, part, whole.goals.base_offset);
    if (plan.executable()) return as_part(std::move(plan), last, whole);
  }
  return whole;
}

}  // namespace morphe::planning
