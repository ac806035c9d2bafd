#include "pipeline/explain/path_violations.hpp"

#include <algorithm>
#include <functional>

#include "core/collision/world.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/check/check_path.hpp"

namespace morphe::explain {
namespace {

void keep_worse(const TipError& miss, std::optional<TipError>& worst) {
  const auto beyond = [](const TipError& one) { return one.error_m - one.allowed_m; };
  if (beyond(miss) > (worst ? beyond(*worst) : 0)) worst = miss;
}

void find_tip_errors(const robot::Robot& robot, const Plan& plan, PathViolations& shortfall) {
  if (plan.goals.frames() == 0) return;
  std::vector<Pose> base_from_frame;
  const std::vector<double>& time = plan.path.demonstration_time;
  for (std::size_t k = 0; k < time.size(); ++k) {
    robot::forward_kinematics(robot, plan.path.position.row(k).transpose(), base_from_frame);
    TipError miss;
    miss.time_s = time[k];
    miss.grasping = check::counts_as_grasp(plan.movement, time, k);
    miss.allowed_m = miss.grasping ? plan.tolerances.tracking_tolerance_grasp
                                   : plan.tolerances.tracking_tolerance;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Vec3 goal = tip_goal_at(plan.goals, tip, time[k]);
      if (!is_known(goal)) continue;
      miss.tip = robot.tips[tip].name;
      const double share = pad_share_at(plan.goals, tip, time[k]);
      miss.error_m = (robot::tracked_point(robot, base_from_frame, tip, share) - goal).norm();
      keep_worse(miss, miss.grasping ? shortfall.grasp_tip_error : shortfall.other_tip_error);
    }
  }
}

ClearanceViolation make_clearance_violation(const collision::CollisionWorld& world,
                                            const Finding& finding) {
  ClearanceViolation contact{finding.subject,
                             finding.other_body,
                             finding.begin_s,
                             finding.end_s,
                             finding.excess,
                             world.tolerances.required_clearance,
                             "check.required_clearance",
                             finding.cause != Cause::self_collision};
  const auto named = [](const auto& list, const std::string& name) {
    const auto it = std::ranges::find_if(list, [&](const auto& one) { return one.name == name; });
    return it == list.end() ? -1 : static_cast<int>(it - list.begin());
  };
  const int capsule = named(world.robot->capsules, finding.subject);
  const int object = named(world.scene->objects, finding.other_body);
  if (finding.cause == Cause::self_collision || capsule < 0 || object < 0) return contact;
  const double middle_s = 0.5 * (finding.begin_s + finding.end_s);
  contact.required_m = collision::required_distance_m(world, capsule, object, middle_s);
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
  PathViolations shortfall;
  find_tip_errors(robot, plan, shortfall);
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, plan.tolerances);
  std::vector<Finding> left = plan.remaining_findings.empty() && plan.repair.empty()
                                  ? plan.findings
                                  : plan.remaining_findings;
  std::ranges::stable_sort(left, std::greater{}, &Finding::excess);
  for (const Finding& finding : left) {
    if (is_collision(finding.cause))
      shortfall.contacts.push_back(make_clearance_violation(world, finding));
    if (finding.cause == Cause::jump) shortfall.jumps.push_back(finding);
    if (finding.cause == Cause::joint_limit) shortfall.limits.push_back(finding);
  }
  return shortfall;
}

}  // namespace morphe::explain
