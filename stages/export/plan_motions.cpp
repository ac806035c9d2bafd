#include "stages/export/plan_motions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stages/export/resample.hpp"

namespace morphe::exports {
namespace {

/// Returns the defect of a trajectory that must not be sent to a controller, or "".
std::string trajectory_defect(const Trajectory& t) {
  if (t.samples() < 2) return "the trajectory has fewer than two samples";
  if (!t.position.allFinite() || !t.velocity.allFinite() || !t.acceleration.allFinite())
    return "the trajectory contains values that are not finite numbers";
  for (int i = 0; i < std::ssize(t.time); ++i) {
    const bool increases = i == 0 || t.time[i] > t.time[i - 1];
    if (!increases || !std::isfinite(t.time[i])) return "the trajectory's time does not increase";
    if (static_cast<std::size_t>(t.phase[i]) >= enum_count<PhaseKind>())
      return "the trajectory contains unknown phases";
  }
  return "";
}

/// Returns the reason for which a plan cannot be exported; "" if it can.
std::string rejection_reason(const Plan& plan) {
  if (!plan.has_trajectory()) return fmt::format("{}: {}", name_of(plan.reason), plan.detail);
  if (const std::string defect = trajectory_defect(plan.trajectory); !defect.empty()) return defect;
  for (const Trajectory* motion : {&plan.approach, &plan.retreat}) {
    const std::string defect = motion->samples() > 0 ? trajectory_defect(*motion) : "";
    if (!defect.empty()) return (motion == &plan.approach ? "approach: " : "retreat: ") + defect;
  }
  return "";
}

PlanMotions join_approach_and_retreat(const RobotModel& robot, const Plan& plan) {
  Trajectory joined = plan.trajectory;
  if (plan.approach.samples() > 0) {
    const std::string error = continuity_error(robot, plan.approach, joined);
    if (!error.empty())
      return {{}, "the approach does not end where the trajectory begins: " + error};
    joined = concatenate(adjust_end(plan.approach, joined), joined);
  }
  if (plan.retreat.samples() > 0) {
    const std::string error = continuity_error(robot, joined, plan.retreat);
    if (!error.empty())
      return {{}, "the retreat does not begin where the trajectory ends: " + error};
    joined = concatenate(joined, adjust_begin(plan.retreat, joined));
  }
  return {{{"trajectory", std::move(joined)}}, ""};
}

PlanMotions select_motions(const RobotModel& robot, const Plan& plan, ApproachMode approach) {
  if (approach == ApproachMode::joined) return join_approach_and_retreat(robot, plan);
  std::vector<PlanMotion> motions;
  const bool apart = approach == ApproachMode::apart;
  if (apart && plan.approach.samples() > 0) motions.push_back({"approach", plan.approach});
  motions.push_back({"trajectory", plan.trajectory});
  if (apart && plan.retreat.samples() > 0) motions.push_back({"retreat", plan.retreat});
  return {std::move(motions), ""};
}

}  // namespace

PlanMotions motions_of(const RobotModel& robot, const Plan& plan, const MotionOptions& options) {
  if (const std::string reason = rejection_reason(plan); !reason.empty()) return {{}, reason};
  PlanMotions selected = select_motions(robot, plan, options.approach);
  for (PlanMotion& motion : selected.motions) {
    if (options.delay_s > 0) {
      const std::string error = initial_motion_error(robot, motion.trajectory);
      if (!error.empty())
        return {{}, fmt::format("{}: does not begin at rest: {}", motion.name, error)};
      motion.trajectory = add_initial_wait(motion.trajectory, options.delay_s);
    }
    motion.trajectory = options.uniform ? resample_uniformly(motion.trajectory, options.rate_hz)
                        : options.rate_hz > 0 ? resample(motion.trajectory, options.rate_hz)
                                              : subdivide(motion.trajectory, options.parts);
  }
  return selected;
}

}  // namespace morphe::exports
