#include "pipeline/explain/oversized_target.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::explain {
namespace {

const SceneObject* inferred_target(const Plan& plan, const scene::SceneOptions& options) {
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  const bool as_named = target && options.target.infer && target->name == options.target.name;
  if (!as_named || target->shape != Shape::cylinder || target->time.size() != 1) return nullptr;
  return target;
}

}  // namespace

std::optional<OversizedTarget> find_oversized_target(const RobotModel& robot, const Plan& plan,
                                                     const scene::SceneOptions& options) {
  const SceneObject* target = inferred_target(plan, options);
  if (!target) return std::nullopt;
  const Pose target_from_base = recorded_pose(*target, 0).inverse();
  OversizedTarget found;
  found.radius_m = found.allowed_radius_m = target->size[0];
  for (std::size_t f = 0; f < plan.goals.frames(); ++f) {
    if (plan.goals.time[f] >= target->attach_s) break;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Vec3 goal = plan.goals.tip_position(f, tip);
      if (!is_known(goal)) continue;
      const Vec3 there = target_from_base * goal;
      const double room_m = std::hypot(there.x(), there.y()) - options.target.pad_depth;
      const bool beside = std::abs(there.z()) < 0.5 * target->size[1] + options.target.pad_depth;
      if (!beside || room_m >= found.allowed_radius_m) continue;
      found = {robot.tips[tip].name, plan.goals.time[f], found.radius_m, room_m};
    }
  }
  constexpr double kMinRadiusReduction_m = 0.002;
  return found.allowed_radius_m < found.radius_m - kMinRadiusReduction_m ? std::optional(found)
                                                                         : std::nullopt;
}

}  // namespace morphe::explain
