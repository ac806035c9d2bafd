#include <algorithm>
#include <array>
#include <optional>

#include "stages/verify/contact.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

bool is_allowed_pair(const RobotModel& robot, int first, int second) {
  return std::any_of(robot.allowed_collision_pairs.begin(), robot.allowed_collision_pairs.end(),
                     [&](const auto& pair) {
                       return (pair[0] == first && pair[1] == second) ||
                              (pair[0] == second && pair[1] == first);
                     });
}

}  // namespace

TouchWindow touch_window(const std::vector<Phase>& phases) {
  std::optional<double> preshape, grasp, end;
  const auto earlier = [](std::optional<double>& held, double time_s) {
    if (!held || time_s < *held) held = time_s;
  };
  for (const Phase& phase : phases) {
    if (phase.kind == PhaseKind::preshape) earlier(preshape, phase.begin_s);
    if (phase.kind == PhaseKind::grasp) earlier(grasp, phase.begin_s);
    if (phase.kind == PhaseKind::grasp || phase.kind == PhaseKind::hold ||
        phase.kind == PhaseKind::transport)
      end = std::max(end.value_or(phase.end_s), phase.end_s);
  }
  if (!preshape) preshape = grasp;
  if (!preshape || !end) return {};
  constexpr double kRounding_s = 1e-9;
  return {*preshape - kRounding_s, *end + kRounding_s};
}

std::vector<ContactPair> contact_pairs(const RobotModel& robot, const Plan& plan) {
  std::vector<ContactPair> pairs;
  const int capsules = static_cast<int>(robot.capsules.size());
  for (int i = 0; i < capsules; ++i) {
    const RobotModel::Capsule& a = robot.capsules[i];
    for (int j = i + 1; j < capsules; ++j) {
      const RobotModel::Capsule& b = robot.capsules[j];
      if (a.frame == b.frame || is_allowed_pair(robot, i, j)) continue;
      pairs.push_back({i, j, false, false, false, a.radius + b.radius,
                       relative_motion_bound(robot, i, j), a.name + "/" + b.name});
    }
  }
  const std::vector<PadSphere> pads = pad_spheres(robot);
  for (int i = 0; i < capsules; ++i) {
    const RobotModel::Capsule& a = robot.capsules[i];
    const bool pad = std::any_of(pads.begin(), pads.end(),
                                 [&](const PadSphere& one) { return one.capsule == i; });
    for (std::size_t k = 0; k < plan.scene.objects.size(); ++k) {
      const SceneObject& object = plan.scene.objects[k];
      if (!has_valid_shape(object)) continue;
      const bool target = !plan.movement.target.empty() && object.name == plan.movement.target;
      pairs.push_back({i, static_cast<int>(k), true, target && a.may_touch_target, pad, a.radius,
                       relative_motion_bound(robot, i, -1), a.name + "/" + object.name});
    }
  }
  return pairs;
}

}  // namespace morphe::verify
