#include "stages/export/plan_motions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stages/export/resample.hpp"

namespace morphe::exports {
namespace {

/// What no controller may be given, whatever the file calls it; "" if it may.
std::string what_is_wrong(const Trajectory& t) {
  if (t.samples() < 2) return "the trajectory has fewer than two samples";
  if (!t.position.allFinite() || !t.velocity.allFinite() || !t.acceleration.allFinite()) {
    return "the trajectory holds what is no number";
  }
  for (std::size_t i = 0; i < t.samples(); ++i) {
    const bool later = i == 0 ? std::isfinite(t.time[0]) : t.time[i] > t.time[i - 1];
    if (!later || !std::isfinite(t.time[i])) return "the trajectory's time does not increase";
    if (!(static_cast<std::size_t>(t.phase[i]) < count_of<PhaseKind>()))
      return "the trajectory holds unknown phases";
  }
  return "";
}

/// "" if a plan can be exported.
std::string why_not(const Plan& plan) {
  if (!plan.has_trajectory()) return fmt::format("{}: {}", name_of(plan.reason), plan.detail);
  if (const std::string wrong = what_is_wrong(plan.trajectory); !wrong.empty()) return wrong;
  for (const Trajectory* way : {&plan.approach, &plan.retreat}) {
    const std::string wrong = way->samples() > 0 ? what_is_wrong(*way) : "";
    if (!wrong.empty()) return (way == &plan.approach ? "approach: " : "retreat: ") + wrong;
  }
  return "";
}

PlanMotions with_ways(const RobotTable& robot, const Plan& plan) {
  Trajectory whole = plan.trajectory;
  if (plan.approach.samples() > 0) {
    const std::string why = why_not_joined(robot, plan.approach, whole);
    if (!why.empty()) return {{}, "the approach does not end where the trajectory begins: " + why};
    whole = joined(ending_at(plan.approach, whole), whole);
  }
  if (plan.retreat.samples() > 0) {
    const std::string why = why_not_joined(robot, whole, plan.retreat);
    if (!why.empty()) return {{}, "the retreat does not begin where the trajectory ends: " + why};
    whole = joined(whole, beginning_at(plan.retreat, whole));
  }
  return {{{"trajectory", std::move(whole)}}, ""};
}

PlanMotions chosen(const RobotTable& robot, const Plan& plan, Ways approach) {
  if (approach == Ways::joined) return with_ways(robot, plan);
  PlanMotions found;
  const bool apart = approach == Ways::apart;
  if (apart && plan.approach.samples() > 0) found.motions.push_back({"approach", plan.approach});
  found.motions.push_back({"trajectory", plan.trajectory});
  if (apart && plan.retreat.samples() > 0) found.motions.push_back({"retreat", plan.retreat});
  return found;
}

}  // namespace

PlanMotions motions_of(const RobotTable& robot, const Plan& plan, const MotionOptions& options) {
  if (const std::string why = why_not(plan); !why.empty()) return {{}, why};
  PlanMotions found = chosen(robot, plan, options.approach);
  for (PlanMotion& motion : found.motions) {
    if (options.delay_s > 0) {
      const std::string why = why_not_delayed(robot, motion.trajectory);
      if (!why.empty())
        return {{}, fmt::format("{}: does not begin at rest: {}", motion.what, why)};
      motion.trajectory = delayed(motion.trajectory, options.delay_s);
    }
    if (options.rate_hz > 0) motion.trajectory = resampled(motion.trajectory, options.rate_hz);
  }
  return found;
}

}  // namespace morphe::exports
