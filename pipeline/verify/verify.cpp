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

std::vector<Violation> verify_approach(const RobotTable& robot, const std::string& plan_path,
                                       const Plan& plan) {
  judge::ViolationRuns runs(plan_path + "/approach");
  if (judge::judge_approach_structure(robot, plan, runs)) {
    const judge::Curve curve = judge::make_curve(plan.approach);
    judge::judge_rest(robot, plan.approach, runs);
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
  append(violations, verify_approach(robot, plan_path, plan));
  return violations;
}

}  // namespace morphe
