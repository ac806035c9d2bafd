#include "pipeline/explain/oversized_target.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::explain {
namespace {

const SceneObject* inferred_target(const Plan& plan, const scene::SceneOptions& options) {
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (!target) return nullptr;
  // Files of earlier versions do not say it.
  const bool inferred = target->shape_origin == ObjectOrigin::unknown
                            ? options.target.infer && target->name == options.target.name
                            : target->shape_origin == ObjectOrigin::inferred;
  if (!inferred || target->shape != Shape::cylinder || target->time.size() != 1) return nullptr;
  return target;
}

}  // namespace

std::optional<OversizedTarget> find_oversized_target(const RobotModel& robot, const Plan& plan,
                                                     const scene::SceneOptions& options) {
  const SceneObject* target = inferred_target(plan, options);
  if (!target) return std::nullopt;
  const Pose target_from_base = recorded_pose(*target, 0).inverse();
  const double pad_depth = options.target.pad_depth;
  OversizedTarget result;
  result.radius_m = result.allowed_radius_m = target->size[0];
  for (int f = 0; f < std::ssize(plan.goals.time); ++f) {
    if (plan.goals.time[f] >= target->attach_s) break;
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      if (!is_known(plan.goals.tip_position(f, tip))) continue;
      const Vec3 goal = target_from_base * plan.goals.tip_position(f, tip);
      const double radius_m = std::hypot(goal.x(), goal.y()) - pad_depth;
      const bool at_height = std::abs(goal.z()) < 0.5 * target->size[1] + pad_depth;
      if (at_height && radius_m < result.allowed_radius_m)
        result = {robot.tips[tip].name, plan.goals.time[f], result.radius_m, radius_m};
    }
  }
  constexpr double kMinRadiusReduction_m = 0.002;
  if (!(result.allowed_radius_m < result.radius_m - kMinRadiusReduction_m)) return std::nullopt;
  return result;
}

}  // namespace morphe::explain
