#include "pipeline/verify/verify.hpp"

#include "pipeline/verify/certificate.hpp"
#include "pipeline/verify/contact.hpp"
#include "pipeline/verify/structure.hpp"
#include "pipeline/verify/tracking.hpp"

namespace morphe {
namespace {

void append(std::vector<Violation>& all, std::vector<Violation> more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// An approach (`at_its_end` it meets the trajectory) or a retreat.
std::vector<Violation> verify_transfer(const RobotTable& robot, const std::string& path,
                                       const Plan& plan, const Trajectory& transfer,
                                       bool at_its_end) {
  judge::ViolationRuns runs(path);
  if (judge::judge_transfer_structure(robot, plan, transfer, at_its_end, runs)) {
    const judge::Curve curve = judge::make_curve(transfer);
    judge::judge_rest(robot, transfer, runs);
    judge::judge_limits(robot, curve, runs);
    judge::judge_contacts(robot, plan, curve, runs);
  }
  return runs.finish();
}

}  // namespace

std::vector<Violation> verify_plan(const RobotTable& robot, const std::string& plan_path,
                                   const Plan& plan) {
  judge::ViolationRuns runs(plan_path);
  if (!judge::judge_structure(robot, plan, runs)) return runs.finish();
  const judge::Curve curve = judge::make_curve(plan.trajectory);
  judge::judge_rest(robot, plan.trajectory, runs);
  const judge::LimitUse use = judge::judge_limits(robot, curve, runs);
  judge::judge_tracking(robot, plan, runs);
  const double clearance = judge::judge_contacts(robot, plan, curve, runs);
  judge::judge_certificate(robot, plan, curve, use, clearance, runs);
  std::vector<Violation> violations = runs.finish();
  append(violations, verify_transfer(robot, plan_path + "/approach", plan, plan.approach, true));
  append(violations, verify_transfer(robot, plan_path + "/retreat", plan, plan.retreat, false));
  return violations;
}

}  // namespace morphe
