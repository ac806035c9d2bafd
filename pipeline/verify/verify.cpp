#include "pipeline/verify/verify.hpp"

#include "pipeline/verify/certificate.hpp"
#include "pipeline/verify/contact.hpp"
#include "pipeline/verify/grasp_contacts.hpp"
#include "pipeline/verify/grasp_pose.hpp"
#include "pipeline/verify/grasp_quality.hpp"
#include "pipeline/verify/squeeze.hpp"
#include "pipeline/verify/status.hpp"
#include "pipeline/verify/structure.hpp"
#include "pipeline/verify/tracking.hpp"
#include "pipeline/verify/violation_unit.hpp"

namespace morphe::verify {
namespace {

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// An approach (`at_its_end` it meets the trajectory) or a retreat.
std::vector<Violation> verify_transfer(const RobotTable& robot, const std::string& path,
                                       const Plan& plan, const Trajectory& transfer,
                                       bool at_its_end) {
  ViolationRuns runs(path);
  if (judge_transfer_structure(robot, plan, transfer, at_its_end, runs)) {
    const Curve curve = make_curve(transfer);
    judge_rest(robot, transfer, runs);
    judge_limits(robot, curve, runs);
    judge_contacts(robot, plan, curve, runs);
  }
  return runs.finish();
}

void judge_grasp(const RobotTable& robot, const Plan& plan, const std::string& config,
                 ViolationRuns& runs) {
  const Grasp& grasp = plan.grasp;
  if (grasp.sample < 0) return;
  if (!judge_grasp_pose(robot, plan, runs)) return;
  if (grasp.contacts.empty()) {
    if (grasp.squeeze_torque.size() > 0) runs.note_plan("structure", "grasp/squeeze", 0, kNotSeen);
    return;
  }
  if (!judge_grasp_contacts(robot, plan, runs)) return;
  judge_grasp_quality(robot, plan, config, runs);
  judge_squeeze(robot, plan, config, runs);
}

std::vector<Violation> judged(const RobotTable& robot, const std::string& plan_path,
                              const Plan& plan, const std::string& config) {
  ViolationRuns runs(plan_path);
  if (!judge_structure(robot, plan, runs)) return runs.finish();
  const Curve curve = make_curve(plan.trajectory);
  judge_rest(robot, plan.trajectory, runs);
  const LimitUse use = judge_limits(robot, curve, runs);
  judge_tracking(robot, plan, runs);
  judge_status(robot, plan, runs);
  const double clearance = judge_contacts(robot, plan, curve, runs);
  judge_certificate(robot, plan, curve, use, clearance, runs);
  judge_grasp(robot, plan, config, runs);
  std::vector<Violation> violations = runs.finish();
  append(violations, verify_transfer(robot, plan_path + "/approach", plan, plan.approach, true));
  append(violations, verify_transfer(robot, plan_path + "/retreat", plan, plan.retreat, false));
  return violations;
}

}  // namespace

std::vector<Violation> verify_plan(const RobotTable& robot, const std::string& plan_path,
                                   const Plan& plan, const std::string& config) {
  std::vector<Violation> violations = judged(robot, plan_path, plan, config);
  for (Violation& violation : violations) violation.unit = unit_of(robot, violation);
  return violations;
}

}  // namespace morphe::verify
