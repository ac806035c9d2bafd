#include "stages/verify/verify.hpp"

#include <utility>

#include "stages/verify/approach_retreat.hpp"
#include "stages/verify/branch.hpp"
#include "stages/verify/certificate.hpp"
#include "stages/verify/contact.hpp"
#include "stages/verify/delivered_part.hpp"
#include "stages/verify/goals.hpp"
#include "stages/verify/grasp_contacts.hpp"
#include "stages/verify/grasp_forces.hpp"
#include "stages/verify/grasp_pose.hpp"
#include "stages/verify/grasp_quality.hpp"
#include "stages/verify/mapping.hpp"
#include "stages/verify/path.hpp"
#include "stages/verify/phases.hpp"
#include "stages/verify/requirements.hpp"
#include "stages/verify/scene.hpp"
#include "stages/verify/status.hpp"
#include "stages/verify/structure.hpp"
#include "stages/verify/tracking.hpp"
#include "stages/verify/violation_unit.hpp"

namespace morphe::verify {
namespace {

std::vector<Violation> verify_approach_or_retreat(const RobotModel& robot, const std::string& path,
                                                  const Plan& plan, ApproachOrRetreat kind,
                                                  const PlanRequest* request) {
  const bool approach = kind == ApproachOrRetreat::approach;
  const Trajectory& motion = approach ? plan.approach : plan.retreat;
  ViolationLog violations(path + (approach ? "/approach" : "/retreat"));
  if (!verify_approach_retreat_structure(robot, plan, motion, approach, violations))
    return violations.finish();
  const Curve curve = make_curve(motion);
  verify_rest(robot, curve, violations);
  const LimitUse use = verify_limits(robot, curve, violations);
  verify_contacts(robot, plan, curve, violations);
  verify_approach_retreat(plan, motion, kind, request, violations);
  if (request && request->home)
    verify_limit_scaling(use, request->limit_scaling * request->home->limit_scaling, violations);
  return violations.finish();
}

void verify_grasp(const RobotModel& robot, const Plan& plan, const std::string& config,
                  ViolationLog& violations) {
  if (!has_grasp(plan) || !verify_grasp_pose(robot, plan, violations)) return;
  if (plan.grasp.contacts.empty() && plan.grasp.grasp_torque.size() > 0)
    violations.note_plan("structure", "grasp/grasp_force", 0, kUnknown);
  if (!verify_grasp_contacts(robot, plan, violations)) return;
  verify_grasp_quality(robot, plan, config, violations);
  verify_grasp_forces(robot, plan, config, violations);
}

void verify_infeasible(const RobotModel& robot, const Plan& plan, const PlanRequest* request,
                       ViolationLog& violations) {
  verify_no_certificate(plan, violations);
  verify_phases(plan, violations);
  if (request) verify_infeasible_requirements(robot, plan, *request, violations);
}

std::vector<Violation> verify_trajectory_and_contents(const RobotModel& robot,
                                                      const std::string& plan_path,
                                                      const Plan& plan, const std::string& config,
                                                      const PlanRequest* request) {
  ViolationLog violations(plan_path);
  if (!verify_structure(robot, plan, violations)) {
    if (!plan.has_trajectory()) verify_infeasible(robot, plan, request, violations);
    return violations.finish();
  }
  const Curve curve = make_curve(plan.trajectory);
  verify_rest(robot, curve, violations);
  const LimitUse use = verify_limits(robot, curve, violations);
  if (request) verify_limit_scaling(use, request->limit_scaling, violations);
  verify_tracking(robot, plan, curve, violations);
  verify_status(robot, plan, violations);
  const ClearanceByKind clearance = verify_contacts(robot, plan, curve, violations);
  verify_certificate(robot, plan, curve, use, clearance, violations);
  verify_phases(plan, violations);
  verify_delivered_part(plan, request, violations);
  verify_goals(robot, plan, violations);
  verify_scene(robot, plan, violations);
  verify_mapping(robot, plan, violations);
  verify_branch(robot, plan, violations);
  verify_path(robot, plan, violations);
  verify_grasp(robot, plan, config, violations);
  if (request) verify_requirements(robot, plan, *request, violations);
  std::vector<Violation> all = violations.finish();
  for (const auto kind : {ApproachOrRetreat::approach, ApproachOrRetreat::retreat})
    for (Violation& violation : verify_approach_or_retreat(robot, plan_path, plan, kind, request))
      all.push_back(std::move(violation));
  return all;
}

}  // namespace

std::vector<Violation> verify_plan(const RobotModel& robot, const std::string& plan_path,
                                   const Plan& plan, const std::string& config,
                                   const PlanRequest* request) {
  std::vector<Violation> violations =
      verify_trajectory_and_contents(robot, plan_path, plan, config, request);
  for (Violation& violation : violations) violation.unit = unit_of(robot, violation);
  return violations;
}

}  // namespace morphe::verify
