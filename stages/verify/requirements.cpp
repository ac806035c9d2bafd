#include "stages/verify/requirements.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kPhaseTimeTolerance_s = 1e-9, kBodyPoseTolerance = 1e-6,
                 kGoalStepTolerance_s = 1e-6;

bool same_number(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b)) || (std::isnan(a) && std::isnan(b));
}

void verify_tolerances(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs) {
  const Tolerances &own = plan.tolerances, &wanted = asked.tolerances;
  const auto holds = [&](const char* name, double is, double should) {
    if (!same_number(is, should)) runs.note_plan("config", name, is, should);
  };
  holds("required_clearance", own.required_clearance, wanted.required_clearance);
  holds("max_penetration", own.max_penetration, wanted.max_penetration);
  holds("max_link_penetration", own.max_link_penetration.value_or(kUnknown),
        wanted.max_link_penetration.value_or(kUnknown));
  holds("tracking_tolerance_grasp", own.tracking_tolerance_grasp, wanted.tracking_tolerance_grasp);
  holds("tracking_tolerance", own.tracking_tolerance, wanted.tracking_tolerance);
  holds("max_unreachable_share", own.max_unreachable_share, wanted.max_unreachable_share);
  holds("max_tip_error", own.max_tip_error, wanted.max_tip_error);
}

void verify_plan_times(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs) {
  const std::vector<double>& time = plan.goals.time;
  if (time.size() > 1) {
    const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    if (!(std::abs(step_s - asked.goal_step_s) <= kGoalStepTolerance_s))
      runs.note_plan("config", "goals", step_s, asked.goal_step_s);
  }
  const std::vector<Phase>& phases = plan.movement.phases;
  if (!asked.plan_until || phases.empty()) return;
  const auto holds = [&](const char* name, double is, double should) {
    if (!(std::abs(is - should) <= kPhaseTimeTolerance_s))
      runs.note_plan("config", name, is, should);
  };
  holds("begin_s", plan.movement.begin_s, phases.front().begin_s);
  const Phase* last = last_phase(plan.movement, *asked.plan_until);
  if (!last) last = last_phase(plan.movement, PhaseKind::grasp);
  if (last) holds("end_s", plan.movement.end_s, last->end_s);
}

void verify_approach_retreat_present(const Plan& plan, const PlanRequest& asked,
                                     ViolationCollector& runs) {
  const auto holds = [&](const char* name, const Trajectory& motion, bool wanted) {
    if ((motion.samples() > 0) != wanted)
      runs.note_plan("config", name, static_cast<double>(motion.samples()), wanted ? 2 : 0);
  };
  holds("approach", plan.approach, asked.home.has_value());
  holds("retreat", plan.retreat, asked.home && asked.home->with_retreat);
}

/// Returns the frame that a body's pose is relative to, at the begin of the movement; not finite if
/// it is absent.
Pose base_from(PlanRequest::ReferenceFrame frame, const WorldFrames& world) {
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

bool same_shape(const SceneObject& own, const SceneObject& wanted) {
  if (own.shape != wanted.shape || own.size.size() != wanted.size.size() ||
      own.vertices.size() != wanted.vertices.size() || own.triangles != wanted.triangles)
    return false;
  for (std::size_t i = 0; i < own.size.size(); ++i)
    if (!same_number(own.size[i], wanted.size[i])) return false;
  for (std::size_t i = 0; i < own.vertices.size(); ++i)
    if (!((own.vertices[i] - wanted.vertices[i]).norm() <= kBodyPoseTolerance)) return false;
  return true;
}

void verify_scene_bodies(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs) {
  for (const PlanRequest::Body& body : asked.bodies) {
    const SceneObject* own = find_object(plan.scene.objects, body.object.name);
    const bool named_only = body.relative_to == PlanRequest::ReferenceFrame::unknown;
    if (!own || own->time.size() != 1 || !(named_only || same_shape(*own, body.object))) {
      runs.note_plan("config", body.object.name, kUnknown, kUnknown);
      continue;
    }
    if (named_only) continue;
    const Pose place = base_from(body.relative_to, plan.reference_frames) *
                       make_pose(body.object.position[0], body.object.orientation[0]);
    const Pose is = make_pose(own->position[0], own->orientation[0]);
    const double off = (is.matrix() - place.matrix()).cwiseAbs().maxCoeff();
    if (!(off <= kBodyPoseTolerance))
      runs.note_plan("config", body.object.name, off, kBodyPoseTolerance);
  }
}

void verify_attached_frame(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs) {
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target || plan.movement.target.empty()) return;
  const bool carried = target->attach_s < plan.movement.end_s;
  if (target->attached_frame != (carried ? asked.carrier_frame : ""))
    runs.note_plan("config", "carried_by", kUnknown, kUnknown);
}

}  // namespace

void verify_requirements(const Plan& plan, const PlanRequest& asked, ViolationCollector& runs) {
  verify_tolerances(plan, asked, runs);
  verify_plan_times(plan, asked, runs);
  verify_approach_retreat_present(plan, asked, runs);
  verify_scene_bodies(plan, asked, runs);
  verify_attached_frame(plan, asked, runs);
}

}  // namespace morphe::verify
