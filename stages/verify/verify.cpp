#include "stages/verify/verify.hpp"

#include "stages/verify/approach_retreat.hpp"
#include "stages/verify/certificate.hpp"
#include "stages/verify/contact.hpp"
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

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<Violation> verify_approach_retreat_motion(const RobotModel& robot,
                                                      const std::string& path, const Plan& plan,
                                                      const Trajectory& motion,
                                                      ApproachOrRetreat which,
                                                      const PlanRequest* asked) {
  ViolationCollector runs(path);
  if (verify_approach_retreat_structure(robot, plan, motion, which == ApproachOrRetreat::approach,
                                        runs)) {
    const Curve curve = make_curve(motion);
    verify_rest(robot, motion, runs);
    const LimitUse use = verify_limits(robot, curve, runs);
    verify_contacts(robot, plan, curve, runs);
    verify_approach_retreat(plan, motion, which, asked, runs);
    if (asked && asked->home)
      verify_limit_scaling(use, asked->limit_scaling * asked->home->limit_scaling, runs);
  }
  return runs.finish();
}

void verify_grasp(const RobotModel& robot, const Plan& plan, const std::string& config,
                  ViolationCollector& runs) {
  if (!has_grasp(plan) || !verify_grasp_pose(robot, plan, runs)) return;
  if (plan.grasp.contacts.empty() && plan.grasp.grasp_torque.size() > 0)
    runs.note_plan("structure", "grasp/grasp_force", 0, kUnknown);
  if (!verify_grasp_contacts(robot, plan, runs)) return;
  verify_grasp_quality(robot, plan, config, runs);
  verify_grasp_forces(robot, plan, config, runs);
}

/// Verifies the parts of the plan beside the motion: the person's movement, the world frames and
/// the plan's own attributes.
void verify_plan_contents(const RobotModel& robot, const Plan& plan, const std::string& config,
                          const PlanRequest* asked, ViolationCollector& runs) {
  verify_phases(plan, runs);
  verify_goals(robot, plan, runs);
  verify_scene(robot, plan, runs);
  verify_mapping(robot, plan, runs);
  verify_path(robot, plan, runs);
  verify_grasp(robot, plan, config, runs);
  if (asked) verify_requirements(plan, *asked, runs);
}

std::vector<Violation> judged(const RobotModel& robot, const std::string& plan_path,
                              const Plan& plan, const std::string& config,
                              const PlanRequest* asked) {
  ViolationCollector runs(plan_path);
  if (!verify_structure(robot, plan, runs)) return runs.finish();
  const Curve curve = make_curve(plan.trajectory);
  verify_rest(robot, plan.trajectory, runs);
  const LimitUse use = verify_limits(robot, curve, runs);
  if (asked) verify_limit_scaling(use, asked->limit_scaling, runs);
  verify_tracking(robot, plan, curve, runs);
  verify_status(robot, plan, runs);
  const double clearance = verify_contacts(robot, plan, curve, runs);
  verify_certificate(robot, plan, curve, use, clearance, runs);
  verify_plan_contents(robot, plan, config, asked, runs);
  std::vector<Violation> violations = runs.finish();
  const auto transfer = [&](const char* name, const Trajectory& motion, ApproachOrRetreat which) {
    append(violations, verify_approach_retreat_motion(robot, plan_path + "/" + name, plan, motion,
                                                      which, asked));
  };
  transfer("approach", plan.approach, ApproachOrRetreat::approach);
  transfer("retreat", plan.retreat, ApproachOrRetreat::retreat);
  return violations;
}

}  // namespace

std::vector<Violation> verify_plan(const RobotModel& robot, const std::string& plan_path,
                                   const Plan& plan, const std::string& config,
                                   const PlanRequest* asked) {
  std::vector<Violation> violations = judged(robot, plan_path, plan, config, asked);
  for (Violation& violation : violations) violation.unit = unit_of(robot, violation);
  return violations;
}

}  // namespace morphe::verify
