#include "stages/verify/verify.hpp"

#include "stages/verify/as_asked.hpp"
#include "stages/verify/certificate.hpp"
#include "stages/verify/contact.hpp"
#include "stages/verify/grasp_contacts.hpp"
#include "stages/verify/grasp_pose.hpp"
#include "stages/verify/grasp_quality.hpp"
#include "stages/verify/mapped.hpp"
#include "stages/verify/path.hpp"
#include "stages/verify/phases.hpp"
#include "stages/verify/promised_goals.hpp"
#include "stages/verify/scene.hpp"
#include "stages/verify/squeeze.hpp"
#include "stages/verify/status.hpp"
#include "stages/verify/structure.hpp"
#include "stages/verify/tracking.hpp"
#include "stages/verify/transfer.hpp"
#include "stages/verify/violation_unit.hpp"

namespace morphe::verify {
namespace {

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<Violation> verify_transfer(const RobotTable& robot, const std::string& path,
                                       const Plan& plan, const Trajectory& motion, Transfer which,
                                       const Asked* asked) {
  ViolationRuns runs(path);
  if (judge_transfer_structure(robot, plan, motion, which == Transfer::approach, runs)) {
    const Curve curve = make_curve(motion);
    judge_rest(robot, motion, runs);
    const LimitUse use = judge_limits(robot, curve, runs);
    judge_contacts(robot, plan, curve, runs);
    judge_transfer(plan, motion, which, asked, runs);
    if (asked && asked->home) judge_share(use, asked->limit_share * asked->home->limit_share, runs);
  }
  return runs.finish();
}

void judge_grasp(const RobotTable& robot, const Plan& plan, const std::string& config,
                 ViolationRuns& runs) {
  if (!has_grasp(plan) || !judge_grasp_pose(robot, plan, runs)) return;
  if (plan.grasp.contacts.empty() && plan.grasp.squeeze_torque.size() > 0)
    runs.note_plan("structure", "grasp/squeeze", 0, kNotSeen);
  if (!judge_grasp_contacts(robot, plan, runs)) return;
  judge_grasp_quality(robot, plan, config, runs);
  judge_squeeze(robot, plan, config, runs);
}

/// What the plan says of the person, the world and itself, beside the motion.
void judge_promises(const RobotTable& robot, const Plan& plan, const std::string& config,
                    const Asked* asked, ViolationRuns& runs) {
  judge_phases(plan, runs);
  judge_promised_goals(robot, plan, runs);
  judge_scene(robot, plan, runs);
  judge_mapped(robot, plan, runs);
  judge_path(robot, plan, runs);
  judge_grasp(robot, plan, config, runs);
  if (asked) judge_as_asked(plan, *asked, runs);
}

std::vector<Violation> judged(const RobotTable& robot, const std::string& plan_path,
                              const Plan& plan, const std::string& config, const Asked* asked) {
  ViolationRuns runs(plan_path);
  if (!judge_structure(robot, plan, runs)) return runs.finish();
  const Curve curve = make_curve(plan.trajectory);
  judge_rest(robot, plan.trajectory, runs);
  const LimitUse use = judge_limits(robot, curve, runs);
  if (asked) judge_share(use, asked->limit_share, runs);
  judge_tracking(robot, plan, curve, runs);
  judge_status(robot, plan, runs);
  const double clearance = judge_contacts(robot, plan, curve, runs);
  judge_certificate(robot, plan, curve, use, clearance, runs);
  judge_promises(robot, plan, config, asked, runs);
  std::vector<Violation> violations = runs.finish();
  const auto transfer = [&](const char* name, const Trajectory& motion, Transfer which) {
    append(violations, verify_transfer(robot, plan_path + "/" + name, plan, motion, which, asked));
  };
  transfer("approach", plan.approach, Transfer::approach);
  transfer("retreat", plan.retreat, Transfer::retreat);
  return violations;
}

}  // namespace

std::vector<Violation> verify_plan(const RobotTable& robot, const std::string& plan_path,
                                   const Plan& plan, const std::string& config,
                                   const Asked* asked) {
  std::vector<Violation> violations = judged(robot, plan_path, plan, config, asked);
  for (Violation& violation : violations) violation.unit = unit_of(robot, violation);
  return violations;
}

}  // namespace morphe::verify
