#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "stages/verify/contact.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

/// Returns the allowed pairs of capsules, the lower index first, in ascending order.
std::vector<std::pair<int, int>> allowed_pairs(const RobotModel& robot) {
  std::vector<std::pair<int, int>> allowed;
  for (const auto& pair : robot.allowed_collision_pairs)
    allowed.push_back(std::minmax(pair[0], pair[1]));
  std::ranges::sort(allowed);
  return allowed;
}

}  // namespace

TouchWindow touch_window(const std::vector<Phase>& phases) {
  std::optional<double> preshape_s, grasp_s, end_s;
  const auto lower_to = [](std::optional<double>& least_s, double time_s) {
    if (!least_s || time_s < *least_s) least_s = time_s;
  };
  for (const Phase& phase : phases) {
    const bool grasp = phase.kind == PhaseKind::grasp;
    if (phase.kind == PhaseKind::preshape) lower_to(preshape_s, phase.begin_s);
    if (grasp) lower_to(grasp_s, phase.begin_s);
    if (grasp || phase.kind == PhaseKind::hold || phase.kind == PhaseKind::transport)
      end_s = std::max(end_s.value_or(phase.end_s), phase.end_s);
  }
  if (!preshape_s) preshape_s = grasp_s;
  if (!preshape_s || !end_s) return {};
  constexpr double kRounding_s = 1e-9;
  return {*preshape_s - kRounding_s, *end_s + kRounding_s};
}

std::vector<ContactPair> contact_pairs(const RobotModel& robot, const Plan& plan) {
  std::vector<ContactPair> pairs;
  const std::vector<RobotModel::Capsule>& capsules = robot.capsules;
  const std::vector<std::pair<int, int>> allowed = allowed_pairs(robot);
  for (int i = 0; i < std::ssize(capsules); ++i) {
    for (int j = i + 1; j < std::ssize(capsules); ++j) {
      const RobotModel::Capsule &a = capsules[i], &b = capsules[j];
      if (a.frame == b.frame || std::ranges::binary_search(allowed, std::pair(i, j))) continue;
      pairs.push_back({i, j, false, false, false, a.radius + b.radius,
                       relative_motion_bound(robot, i, j), a.name + "/" + b.name});
    }
  }
  const std::vector<PadSphere> pads = pad_spheres(robot);
  for (int i = 0; i < std::ssize(capsules); ++i) {
    const RobotModel::Capsule& a = capsules[i];
    const bool is_pad = std::ranges::find(pads, i, &PadSphere::capsule) != pads.end();
    for (int k = 0; k < std::ssize(plan.scene.objects); ++k) {
      const SceneObject& object = plan.scene.objects[k];
      if (!has_valid_shape(object)) continue;
      const bool target = !plan.movement.target.empty() && object.name == plan.movement.target;
      pairs.push_back({i, k, true, target && a.may_touch_target, is_pad, a.radius,
                       relative_motion_bound(robot, i, -1), a.name + "/" + object.name});
    }
  }
  return pairs;
}

}  // namespace morphe::verify
