#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/collision/mesh_solid.hpp"
#include "core/collision/world.hpp"

namespace morphe::collision {
namespace {

/// Within which a time counts as on the border of the time in which contact is allowed, as in
/// stages/verify: a sample on the border may be off by the rounding of its time, about 1e-15 s.
constexpr double kTouchBorder_s = 1e-9;

/// Returns the frame that moves a capsule, or -1 if no joint moves it.
int moving_frame(const robot::Robot& robot, int capsule) {
  const int frame = robot.capsules[capsule].frame;
  return frame < 0 ? -1 : robot.moving_frame[frame];
}

CapsulePairs pairs_to_check(const robot::Robot& robot) {
  const std::size_t count = robot.capsules.size();
  std::vector<char> allowed(count * count, 0);
  for (const auto& [i, j] : robot.allowed_collision_pairs)
    allowed[i * count + j] = allowed[j * count + i] = 1;
  std::vector<std::array<int, 2>> pairs;
  for (int i = 0; i < std::ssize(robot.capsules); ++i) {
    for (int j = i + 1; j < std::ssize(robot.capsules); ++j) {
      const bool rigid = moving_frame(robot, i) == moving_frame(robot, j);
      if (!rigid && !allowed[i * count + j]) pairs.push_back({i, j});
    }
  }
  return {robot, std::move(pairs)};
}

void set_contact_time(const Movement& movement, CollisionWorld& world) {
  double preshape_s = kUnknown, grasp_s = kUnknown, end_s = kUnknown;
  const auto keep_earlier = [](double& earliest_s, double time_s) {
    if (!(earliest_s <= time_s)) earliest_s = time_s;  // for NaN too
  };
  for (const Phase& phase : movement.phases) {
    if (phase.kind == PhaseKind::preshape) keep_earlier(preshape_s, phase.begin_s);
    if (phase.kind == PhaseKind::grasp) keep_earlier(grasp_s, phase.begin_s);
    const bool holding = phase.kind == PhaseKind::grasp || phase.kind == PhaseKind::hold ||
                         phase.kind == PhaseKind::transport;
    if (holding && !(end_s >= phase.end_s)) end_s = phase.end_s;
  }
  const double begin_s = std::isnan(preshape_s) ? grasp_s : preshape_s;
  if (std::isnan(begin_s) || std::isnan(end_s)) return;
  world.touch_begin_s = begin_s - kTouchBorder_s;
  world.touch_end_s = end_s + kTouchBorder_s;
}

}  // namespace

CollisionWorld make_world(const robot::Robot& robot, const Scene& scene, const Movement& movement,
                          const Tolerances& tolerances, const MeshCache& ready) {
  if (robot.capsule_motion_bounds.rows() != std::ssize(robot.capsules))
    throw std::logic_error("the robot's capsules changed after what follows from them was derived");
  CollisionWorld world;
  world.robot = &robot;
  world.scene = &scene;
  for (const SceneObject& object : scene.objects)
    world.meshes.push_back(mesh_solid_of(object, ready));
  world.tolerances = tolerances;
  for (int k = 0; k < std::ssize(scene.objects) && !movement.target.empty(); ++k) {
    if (world.target < 0 && scene.objects[k].name == movement.target) world.target = k;
  }
  if (world.target >= 0) set_contact_time(movement, world);
  world.pairs = pairs_to_check(robot);
  return world;
}

}  // namespace morphe::collision
