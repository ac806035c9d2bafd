#include "stages/verify/delivered_part.hpp"

#include <cmath>
#include <string>

namespace morphe::verify {
namespace {

constexpr double kEndTolerance_s = 1e-9;

double last_end_s(const Movement& movement, PhaseKind kind) {
  double end_s = kUnknown;
  for (const Phase& phase : movement.phases)
    if (phase.kind == kind) end_s = phase.end_s;
  return end_s;
}

bool ends_plans(PhaseKind kind, bool grasps) {
  switch (kind) {
    case PhaseKind::rest:
    case PhaseKind::preshape:
    case PhaseKind::hold:
    case PhaseKind::approach:
      return false;
    case PhaseKind::reach:
      return !grasps;
    default:
      return grasps;
  }
}

/// Returns true if the target is held and not known to rest at the movement's end: after the grasp,
/// and before the end of the last transport or without a return that follows it.
bool holds_in_air(const Movement& movement) {
  const double taken_s = last_end_s(movement, PhaseKind::grasp),
               put_down_s = last_end_s(movement, PhaseKind::transport),
               back_s = last_end_s(movement, PhaseKind::return_phase);
  if (std::isnan(put_down_s) || !(movement.end_s > taken_s + kEndTolerance_s)) return false;
  return movement.end_s < put_down_s - kEndTolerance_s || !(back_s > put_down_s);
}

}  // namespace

double planned_end_s(const Movement& movement, PhaseKind until) {
  double end_s = last_end_s(movement, until);
  if (std::isnan(end_s) && (until == PhaseKind::lift || until == PhaseKind::place))
    end_s = last_end_s(movement, PhaseKind::transport);
  if (std::isnan(end_s) &&
      (until == PhaseKind::release || until == PhaseKind::retreat || until == PhaseKind::home))
    end_s = last_end_s(movement, PhaseKind::return_phase);
  return std::isnan(end_s) ? last_end_s(movement, PhaseKind::grasp) : end_s;
}

void verify_delivered_part(const Plan& plan, const PlanRequest* request, ViolationLog& violations) {
  if (!plan.delivered) return;
  const auto& [until, requested_end_s] = *plan.delivered;
  const bool grasps = !std::isnan(last_end_s(plan.movement, PhaseKind::grasp));
  const double end_s = last_end_s(plan.movement, until);
  if (!ends_plans(until, grasps) || !(std::abs(plan.movement.end_s - end_s) <= kEndTolerance_s))
    violations.note_plan("status", "delivered_until", plan.movement.end_s, end_s);
  const PartialPlans allowed = request ? request->partial : PartialPlans::in_air;
  if (allowed == PartialPlans::never ||
      (allowed == PartialPlans::at_rest && holds_in_air(plan.movement)))
    violations.note_plan("status", "delivered_until", plan.movement.end_s,
                         last_end_s(plan.movement, PhaseKind::transport));
  if (!(requested_end_s > plan.movement.end_s + kEndTolerance_s))
    violations.note_plan("status", "requested_end_s", requested_end_s, plan.movement.end_s);
}

}  // namespace morphe::verify
