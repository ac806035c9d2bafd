#include "stages/export/plan_motions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stages/export/resample.hpp"

namespace morphe::exports {
namespace {

/// Returns the defect for which a trajectory must not be sent to a controller, whatever its status;
/// "" if it has no defect.
std::string trajectory_defect(const Trajectory& t) {
  if (t.samples() < 2) return "the trajectory has fewer than two samples";
  if (!t.position.allFinite() || !t.velocity.allFinite() || !t.acceleration.allFinite()) {
    return "the trajectory contains values that are not finite numbers";
  }
  for (std::size_t i = 0; i < t.samples(); ++i) {
    const bool later = i == 0 ? std::isfinite(t.time[0]) : t.time[i] > t.time[i - 1];
    if (!later || !std::isfinite(t.time[i])) return "the trajectory's time does not increase";
    if (!(static_cast<std::size_t>(t.phase[i]) < enum_count<PhaseKind>()))
      return "the trajectory contains unknown phases";
  }
  return "";
}

/// Returns the reason for which a plan cannot be exported; "" if it can.
std::string rejection_reason(const Plan& plan) {
  if (!plan.has_trajectory()) return fmt::format("{}: {}", name_of(plan.reason), plan.detail);
  if (const std::string wrong = trajectory_defect(plan.trajectory); !wrong.empty()) return wrong;
  for (const Trajectory* way : {&plan.approach, &plan.retreat}) {
    const std::string wrong = way->samples() > 0 ? trajectory_defect(*way) : "";
    if (!wrong.empty()) return (way == &plan.approach ? "approach: " : "retreat: ") + wrong;
  }
  return "";
}

PlanMotions join_approach_and_retreat(const RobotModel& robot, const Plan& plan) {
  Trajectory whole = plan.trajectory;
  if (plan.approach.samples() > 0) {
    const std::string why = continuity_error(robot, plan.approach, whole);
    if (!why.empty()) return {{}, "the approach does not end where the trajectory begins: " + why};
    whole = concatenate(adjust_end(plan.approach, whole), whole);
  }
  if (plan.retreat.samples() > 0) {
    const std::string why = continuity_error(robot, whole, plan.retreat);
    if (!why.empty()) return {{}, "the retreat does not begin where the trajectory ends: " + why};
    whole = concatenate(whole, adjust_begin(plan.retreat, whole));
  }
  return {{{"trajectory", std::move(whole)}}, ""};
}

PlanMotions select_motions(const RobotModel& robot, const Plan& plan, ApproachMode approach) {
  if (approach == ApproachMode::joined) return join_approach_and_retreat(robot, plan);
  PlanMotions found;
  const bool apart = approach == ApproachMode::apart;
  if (apart && plan.approach.samples() > 0) found.motions.push_back({"approach", plan.approach});
  found.motions.push_back({"trajectory", plan.trajectory});
  if (apart && plan.retreat.samples() > 0) found.motions.push_back({"retreat", plan.retreat});
  return found;
}

}  // namespace

PlanMotions motions_of(const RobotModel& robot, const Plan& plan, const MotionOptions& options) {
  if (const std::string why = rejection_reason(plan); !why.empty()) return {{}, why};
  PlanMotions found = select_motions(robot, plan, options.approach);
  for (PlanMotion& motion : found.motions) {
    if (options.delay_s > 0) {
      const std::string why = initial_motion_error(robot, motion.trajectory);
      if (!why.empty())
        return {{}, fmt::format("{}: does not begin at rest: {}", motion.what, why)};
      motion.trajectory = add_initial_wait(motion.trajectory, options.delay_s);
    }
    if (options.rate_hz > 0) motion.trajectory = resample(motion.trajectory, options.rate_hz);
  }
  return found;
}

}  // namespace morphe::exports
