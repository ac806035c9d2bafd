#include "stages/verify/requirements.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/task.hpp"
#include "stages/verify/delivered_part.hpp"
#include "stages/verify/placement.hpp"

namespace morphe::verify {
namespace {

constexpr double kPhaseTimeTolerance_s = 1e-9, kGoalStepTolerance_s = 1e-6;
constexpr double kSampleStepTolerance_s = 1e-9;
constexpr double kBodyPoseTolerance = 1e-6;

bool same_number(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b)) || (std::isnan(a) && std::isnan(b));
}

void verify_tolerances(const Tolerances& own, const Tolerances& required,
                       ViolationLog& violations) {
  const auto check = [&](const char* name, double value, double expected) {
    if (!same_number(value, expected)) violations.note_plan("config", name, value, expected);
  };
  check("required_clearance", own.required_clearance, required.required_clearance);
  check("max_penetration", own.max_penetration, required.max_penetration);
  check("max_link_penetration", own.max_link_penetration.value_or(kUnknown),
        required.max_link_penetration.value_or(kUnknown));
  check("tracking_tolerance_grasp", own.tracking_tolerance_grasp,
        required.tracking_tolerance_grasp);
  check("tracking_tolerance", own.tracking_tolerance, required.tracking_tolerance);
  check("max_unreachable_share", own.max_unreachable_share, required.max_unreachable_share);
  check("max_tip_error", own.max_tip_error, required.max_tip_error);
  check("max_missing_goal_share", own.max_missing_goal_share, required.max_missing_goal_share);
  check("max_goal_gap_s", own.max_goal_gap_s, required.max_goal_gap_s);
}

void verify_flags(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  for (const RecordingFlag& flag : plan.flags) {
    const bool refused =
        std::ranges::find(request.refused_flags, flag.code) != request.refused_flags.end();
    if (refused && flag.response == FlagResponse::flagged)
      violations.note_plan("flag", std::string(name_of(flag.code)), flag.value, flag.limit);
  }
}

/// Returns the last phase to be planned, by the task's words.
PhaseKind plan_until(const Plan& plan, const PlanRequest& request) {
  for (const auto& [word, until] : request.plan_until_by_task)
    if (contains_word(plan.task, word)) return until;
  return *request.plan_until;
}

/// Records the first step between two samples that is not the controller's.
void verify_sample_steps(const Trajectory& motion, double step_s, ViolationLog& violations) {
  for (std::size_t k = 1; k < motion.time.size(); ++k) {
    const double own_s = motion.time[k] - motion.time[k - 1];
    if (std::abs(own_s - step_s) <= kSampleStepTolerance_s) continue;
    violations.note_plan("config", "sample_rate_hz", 1 / own_s, 1 / step_s);
    return;
  }
}

void verify_plan_times(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  const std::vector<double>& time = plan.goals.time;
  if (time.size() > 1) {
    const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    if (!(std::abs(step_s - request.goal_step_s) <= kGoalStepTolerance_s))
      violations.note_plan("config", "goals", step_s, request.goal_step_s);
  }
  for (const Trajectory* motion : {&plan.trajectory, &plan.approach, &plan.retreat})
    verify_sample_steps(*motion, request.sample_step_s, violations);
  const std::vector<Phase>& phases = plan.movement.phases;
  if (!request.plan_until || phases.empty()) return;
  const auto check = [&](const char* name, double value, double expected) {
    if (!(std::abs(value - expected) <= kPhaseTimeTolerance_s))
      violations.note_plan("config", name, value, expected);
  };
  check("begin_s", plan.movement.begin_s, phases.front().begin_s);
  const double end_s = planned_end_s(plan.movement, plan_until(plan, request));
  if (std::isnan(end_s)) return;
  if (plan.delivered) check("requested_end_s", plan.delivered->requested_end_s, end_s);
  if (!plan.delivered) check("end_s", plan.movement.end_s, end_s);
}

void verify_approach_retreat_present(const Plan& plan, const PlanRequest& request,
                                     ViolationLog& violations) {
  const auto check = [&](const char* name, const Trajectory& motion, bool requested) {
    if ((motion.samples() > 0) != requested)
      violations.note_plan("config", name, static_cast<double>(motion.samples()),
                           requested ? 2 : 0);
  };
  check("approach", plan.approach, request.home.has_value());
  check("retreat", plan.retreat, request.home && request.home->with_retreat);
}

/// Returns base_from_frame of a reference frame at the movement's begin; not finite if absent.
Pose pose_of(PlanRequest::ReferenceFrame frame, const WorldFrames& world) {
  switch (frame) {
    case PlanRequest::ReferenceFrame::base:
      return Pose::Identity();
    case PlanRequest::ReferenceFrame::table:
      return world.base_from_table;
    case PlanRequest::ReferenceFrame::target:
      return world.base_from_target;
    case PlanRequest::ReferenceFrame::shoulder: {
      Pose shoulder = world.base_from_world;
      shoulder.translation() = world.shoulder;
      return shoulder;
    }
    default:
      return world.base_from_world;
  }
}

void verify_scene_bodies(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  for (const PlanRequest::Body& body : request.bodies) {
    const SceneObject* own = find_object(plan.scene.objects, body.object.name);
    if (!own || own->time.size() != 1 || !same_shape(*own, body.object)) {
      violations.note_plan("config", body.object.name, kUnknown, kUnknown);
      continue;
    }
    const Pose required = pose_of(body.relative_to, plan.reference_frames) *
                          make_pose(body.object.position[0], body.object.orientation[0]);
    const Pose stored = make_pose(own->position[0], own->orientation[0]);
    const double error = (stored.matrix() - required.matrix()).cwiseAbs().maxCoeff();
    if (!(error <= kBodyPoseTolerance))
      violations.note_plan("config", body.object.name, error, kBodyPoseTolerance);
  }
}

void verify_attached_frame(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target || plan.movement.target.empty()) return;
  const bool carried = target->attach_s < plan.movement.end_s;
  if (target->attached_frame != (carried ? request.carrier_frame : ""))
    violations.note_plan("config", "carried_by", kUnknown, kUnknown);
}

}  // namespace

void verify_infeasible_requirements(const RobotModel& robot, const Plan& plan,
                                    const PlanRequest& request, ViolationLog& violations) {
  Tolerances own = plan.tolerances;
  own.max_penetration = request.tolerances.max_penetration;
  own.max_link_penetration = request.tolerances.max_link_penetration;
  verify_tolerances(own, request.tolerances, violations);
  verify_plan_times(plan, request, violations);
  if (is_known(plan.reference_frames.base_from_world))
    verify_placement(robot, plan, request, violations);
}

void verify_requirements(const RobotModel& robot, const Plan& plan, const PlanRequest& request,
                         ViolationLog& violations) {
  verify_tolerances(plan.tolerances, request.tolerances, violations);
  verify_flags(plan, request, violations);
  verify_plan_times(plan, request, violations);
  verify_approach_retreat_present(plan, request, violations);
  verify_scene_bodies(plan, request, violations);
  verify_scene_shapes(plan, request, violations);
  verify_placement(robot, plan, request, violations);
  verify_attached_frame(plan, request, violations);
  verify_origins(plan, request, violations);
}

}  // namespace morphe::verify
