#include "pipeline/explain/path_violations.hpp"

#include <algorithm>
#include <functional>

#include "core/collision/world.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/check/check_path.hpp"

namespace morphe::explain {
namespace {

void keep_worse(const TipError& error, std::optional<TipError>& worst) {
  const auto excess = [](const TipError& e) { return e.error_m - e.allowed_m; };
  if (excess(error) > (worst ? excess(*worst) : 0)) worst = error;
}

void find_tip_errors(const robot::Robot& robot, const Plan& plan, PathViolations& violations) {
  if (plan.goals.frames() == 0) return;
  std::vector<Pose> base_from_frame;
  const std::vector<double>& time = plan.path.demonstration_time;
  for (int k = 0; k < std::ssize(time); ++k) {
    robot::forward_kinematics(robot, plan.path.position.row(k).transpose(), base_from_frame);
    TipError error;
    error.time_s = time[k];
    error.grasping = check::counts_as_grasp(plan.movement, time, k);
    error.allowed_m = error.grasping ? plan.tolerances.tracking_tolerance_grasp
                                     : plan.tolerances.tracking_tolerance;
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      const Vec3 goal = tip_goal_at(plan.goals, tip, time[k]);
      if (!is_known(goal)) continue;
      error.tip = robot.tips[tip].name;
      const double share = pad_share_at(plan.goals, tip, time[k]);
      error.error_m = (robot::tracked_point(robot, base_from_frame, tip, share) - goal).norm();
      keep_worse(error, error.grasping ? violations.grasp_tip_error : violations.other_tip_error);
    }
  }
}

template <class List>
int index_of(const List& list, const std::string& name) {
  for (int k = 0; k < std::ssize(list); ++k)
    if (list[k].name == name) return k;
  return -1;
}

ClearanceViolation make_clearance_violation(const collision::CollisionWorld& world,
                                            const Finding& finding) {
  ClearanceViolation contact{finding.subject,
                             finding.other_body,
                             finding.begin_s,
                             finding.end_s,
                             finding.excess,
                             finding.limit,
                             "check.required_clearance",
                             finding.cause != Cause::self_collision};
  const int capsule = index_of(world.robot->capsules, finding.subject);
  const int object = index_of(world.scene->objects, finding.other_body);
  if (finding.cause == Cause::self_collision || capsule < 0 || object < 0) return contact;
  const double middle_s = 0.5 * (finding.begin_s + finding.end_s);
  if (!collision::may_touch(world, capsule, object, middle_s)) return contact;
  const bool pad = robot::is_pad(*world.robot, capsule);
  contact.config_key = !world.tolerances.max_link_penetration ? "check.max_penetration"
                       : pad                                  ? "grasp.max_penetration"
                                                              : "grasp.max_link_penetration";
  return contact;
}

}  // namespace

bool PathViolations::empty() const {
  return !grasp_tip_error && !other_tip_error && contacts.empty() && jumps.empty() &&
         limits.empty();
}

PathViolations find_path_violations(const robot::Robot& robot, const Plan& plan) {
  PathViolations violations;
  find_tip_errors(robot, plan, violations);
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, plan.tolerances);
  const bool old_file = plan.remaining_findings.empty() && plan.repair.empty();
  std::vector<Finding> findings = old_file ? plan.findings : plan.remaining_findings;
  std::ranges::stable_sort(findings, std::greater{}, &Finding::excess_m);
  for (const Finding& finding : findings) {
    if (is_collision(finding.cause))
      violations.contacts.push_back(make_clearance_violation(world, finding));
    if (finding.cause == Cause::jump) violations.jumps.push_back(finding);
    if (finding.cause == Cause::joint_limit) violations.limits.push_back(finding);
  }
  return violations;
}

}  // namespace morphe::explain
