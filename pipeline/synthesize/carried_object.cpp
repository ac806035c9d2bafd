#include "pipeline/synthesize/carried_object.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::synthesize {

SceneObject carried_object(const Script& script, const MotionSamples& samples, double height_m,
                           std::ptrdiff_t first, std::ptrdiff_t last) {
  SceneObject object;
  object.name = "cup";
  object.shape = Shape::cylinder;
  object.size = {script.object_radius, height_m};
  const auto hand = [&](std::ptrdiff_t i) {
    return make_pose(samples.arm[i].pose.wrist, samples.arm[i].pose.world_from_hand);
  };
  const auto grasp = std::ranges::find(script.movements, true, &ScriptedMovement::grasps);
  Pose world_from_object = Pose::Identity();
  if (grasp != script.movements.end()) {
    const auto attached = std::lround(std::floor(grasp->attach_s * samples.rate_hz));
    world_from_object.translation() = 0.5 * (samples.tip(attached, 0) + samples.tip(attached, 1));
    world_from_object.translation().z() =
        std::max(world_from_object.translation().z(), 0.5 * height_m);
  }
  Pose hand_from_object = Pose::Identity();
  bool carried = false;
  auto movement = script.movements.begin();
  for (int i = 0; i <= last; ++i) {
    const double t = samples.time(i);
    while (movement != script.movements.end() && (!movement->grasps || t > movement->release_s)) {
      ++movement;
      carried = false;
    }
    if (movement != script.movements.end() && t >= movement->attach_s) {
      if (!carried) hand_from_object = hand(i).inverse() * world_from_object;
      carried = true;
      world_from_object = hand(i) * hand_from_object;
    }
    if (i < first) continue;
    object.time.push_back(samples.time(i - first));
    object.position.emplace_back(world_from_object.translation());
    object.orientation.emplace_back(world_from_object.linear());
  }
  return object;
}

}  // namespace morphe::synthesize
