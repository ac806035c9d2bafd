#include <algorithm>
#include <cmath>

#include "stages/verify/requirements.hpp"

namespace morphe::verify {
namespace {

constexpr double kSizeTolerance_m = 1e-9;

/// Checks the shape of a target against that of the config: its body, or its radius and the bounds
/// of an inferred radius.
void verify_target_shape(const SceneObject& target, const PlanRequest::TargetShape& asked,
                         ViolationLog& violations) {
  const auto note = [&](const char* what, double value, double limit) {
    violations.note_plan("config", target.name + what, value, limit);
  };
  if (asked.body) {
    if (target.shape_origin != ObjectOrigin::configured || !same_shape(target, *asked.body))
      note("/shape", kUnknown, kUnknown);
    return;
  }
  if (target.pose_origin != ObjectOrigin::inferred || target.size.empty()) return;
  const ObjectOrigin origin = asked.radius ? ObjectOrigin::configured : ObjectOrigin::inferred;
  if (target.shape_origin != origin) note("/shape_origin", kUnknown, kUnknown);
  const double radius = target.size[0];
  const double least = asked.radius.value_or(asked.min_radius);
  const double largest = asked.radius.value_or(asked.max_radius);
  if (!(radius >= least - kSizeTolerance_m)) note("/size", radius, least);
  if (!(radius <= largest + kSizeTolerance_m)) note("/size", radius, largest);
}

/// Checks the capsules of the person's other arm. A recorded object of the same name replaces one,
/// which the plan's detail tells.
void verify_other_arm(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  for (const auto& [name, radius] : request.other_arm) {
    const SceneObject* body = find_object(plan.scene.objects, name);
    if (!body || plan.detail.find(name + " was recorded as an object") != std::string::npos)
      continue;
    const double own = body->shape == Shape::capsule && !body->size.empty() ? body->size[0] : 0;
    if (!(std::abs(own - radius) <= kSizeTolerance_m))
      violations.note_plan("config", name + "/size", own, radius);
  }
}

}  // namespace

bool same_shape(const SceneObject& a, const SceneObject& b) {
  const auto near = [](const Vec3& p, const Vec3& q) { return (p - q).norm() <= 1e-6; };
  const auto same = [](double x, double y) {
    return std::abs(x - y) <= 1e-12 * std::max(1.0, std::abs(y));
  };
  return a.shape == b.shape && a.triangles == b.triangles &&
         std::ranges::equal(a.size, b.size, same) &&
         std::ranges::equal(a.vertices, b.vertices, near);
}

void verify_scene_shapes(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  verify_other_arm(plan, request, violations);
  const bool configured = std::ranges::any_of(request.bodies, [&](const PlanRequest::Body& body) {
    return body.object.name == plan.movement.target;
  });
  const SceneObject* target = find_object(plan.scene.objects, plan.movement.target);
  if (target && !configured) verify_target_shape(*target, request.target, violations);
}

}  // namespace morphe::verify
