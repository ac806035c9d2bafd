#include "pipeline/report/plan_view.hpp"

#include <algorithm>

#include "pipeline/explain/advice.hpp"
#include "stages/certify/smoothness.hpp"

namespace morphe::report {
namespace {

Vec3 first_shoulder(const Goals& goals) {
  for (const Vec3& shoulder : goals.shoulder_position) {
    if (is_known(shoulder)) return without_common_offset(goals, shoulder);
  }
  return Vec3::Zero();
}

/// Returns the mean speed of the tips' goals by central differences [F], NaN at both ends.
std::vector<double> human_speed_of(const Goals& goals) {
  std::vector<double> speed(goals.frames(), kUnknown);
  const std::vector<double> inner = certify::human_speed(goals).speed;
  if (inner.size() + 2 == speed.size()) std::ranges::copy(inner, speed.begin() + 1);
  return speed;
}

std::vector<DisplayMotion> motions_of(const robot::Robot& robot, const Plan& plan) {
  collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, plan.tolerances);
  std::vector<DisplayMotion> motions;
  if (plan.has_trajectory()) {
    collision::attach_target(plan.trajectory.demonstration_time, plan.trajectory.position, world);
    const auto add = [&](const char* name, const Trajectory& trajectory, bool follows_goals) {
      if (trajectory.samples() > 0)
        motions.push_back(display_trajectory(name, world, plan, trajectory, follows_goals));
    };
    add("approach", plan.approach, false);
    add("trajectory", plan.trajectory, true);
    add("retreat", plan.retreat, false);
    return motions;
  }
  const bool has_path = plan.path.position.rows() > 0;
  const JointRows& position = has_path ? plan.path.position : plan.mapped.position;
  if (position.rows() == 0) return motions;
  const std::vector<double>& time = has_path ? plan.path.demonstration_time : plan.goals.time;
  collision::attach_target(time, position, world);
  const std::vector<SampleOrigin> mapped(time.size(), SampleOrigin::mapped);
  motions.push_back(display_path(has_path ? "path" : "mapped", world, plan, position, time,
                                 has_path ? plan.path.origin : mapped));
  return motions;
}

}  // namespace

Vec3 without_common_offset(const Goals& goals, const Vec3& in_common_base) {
  return in_common_base - goals.common_base_offset;
}

PlanView make_plan_view(const robot::Robot& robot,
                        const std::optional<Eigen::Matrix3d>& world_from_base, const Plan& plan,
                        const explain::AdviceContext& context) {
  PlanView view;
  view.upright = world_from_base.has_value();
  if (world_from_base) view.world_from_base.linear() = *world_from_base;
  view.world_from_base.translation() =
      -(view.world_from_base.linear() * first_shoulder(plan.goals));
  view.motions = motions_of(robot, plan);
  view.human_speed = human_speed_of(plan.goals);
  if (!plan.has_trajectory()) {
    view.worst = worst_instant(robot, plan, view.motions);
    for (const explain::Advice& advice : explain::advice_for(robot, plan, context))
      view.advice.push_back(explain::text_of(advice));
  }
  return view;
}

}  // namespace morphe::report
