#include "pipeline/planning/place_movement.hpp"

#include <algorithm>

#include "core/motion/find_world_frames.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/compass_search.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/joint_to_joint.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/other_arm.hpp"
#include "stages/scene/carried_target.hpp"
#include "stages/scene/other_arm.hpp"

namespace morphe::planning {
namespace {

Pose base_from_motion(const PlanningInputs& planner, const HumanMotion& motion,
                      const Movement& movement, const Vec3& offset) {
  map::PlacementOptions placement = planner.config.placement;
  placement.shoulder_offset += offset;
  const robot::Robot& robot = planner.robot;
  if (map::is_hand_only(robot)) return map::place_hand(robot, placement).inverse();
  return map::place_robot(robot, map::shoulder_at_begin(motion, movement), placement).inverse();
}

/// Lets a target that is carried in the movement move with the palm or with the person's tips
/// (`carried_by`). With contacts it moves with both: the hand holds it as one body, and its motion
/// with the tips is the goal.
void carry_target(const PlanningInputs& planner, const HumanMotion& motion,
                  const Movement& movement, Scene& scene) {
  const robot::Robot& robot = planner.robot;
  for (SceneObject& object : scene.objects) {
    if (object.name != movement.target || !(object.attach_s < movement.end_s)) continue;
    if (is_carried_by_palm(planner.config))
      object.attached_frame = robot.frames[robot.palm_frame].name;
    if (planner.config.grasp || !is_carried_by_palm(planner.config))
      scene::move_with_tips(motion, movement, object);
  }
}

/// Returns the objects of the scene that the mapping's clearance term avoids.
Scene select_mapping_scene(const PipelineConfig& config, const Scene& scene,
                           const Movement& movement) {
  std::vector<std::string> names = scene::mapping_obstacles(config.scene, scene);
  if (config.map.avoid_target) names.push_back(movement.target);
  Scene part;
  for (const SceneObject& object : scene.objects) {
    if (std::ranges::find(names, object.name) != names.end()) part.objects.push_back(object);
  }
  return part;
}

}  // namespace

Scene scene_around(const PlanningInputs& planner, const Demonstration& demonstration,
                   const HumanMotion& motion, Movement& movement) {
  if (!map::is_hand_only(planner.robot)) {
    Scene scene = scene::build_scene(planner.config.scene, demonstration, motion, movement);
    carry_target(planner, motion, movement, scene);
    return scene;
  }
  scene::SceneOptions configured = planner.config.scene;
  configured.table = scene::TableOptions{};
  configured.table.infer = false;
  configured.target.infer = false;
  movement.target.clear();
  return scene::build_scene(configured, {}, motion, movement);
}

std::vector<SceneObject> other_arm_obstacles(const PlanningInputs& planner,
                                             const Demonstration& demonstration,
                                             std::vector<std::string>& notes) {
  const PipelineConfig& config = planner.config;
  if (!config.scene.other_arm) return {};
  if (map::is_hand_only(planner.robot)) {
    notes.emplace_back(
        "a hand without an arm has no position in the world: the other arm is not an obstacle");
    return {};
  }
  const HumanMotion other = reconstruct::reconstruct_other_arm(demonstration, config.reconstruct,
                                                               config.human, planner.robot.side);
  if (const PlanningFailure inhuman = reconstruct::check_human_limits(other, config.human)) {
    notes.push_back("the person's other arm is implausible, but still an obstacle: " +
                    inhuman.detail);
  }
  std::vector<SceneObject> capsules = scene::other_arm_capsules(config.scene, other, notes);
  std::erase_if(capsules, [&](const SceneObject& capsule) {
    const bool recorded = find_object(demonstration.objects, capsule.name) != nullptr;
    if (recorded) notes.push_back(capsule.name + " was recorded as an object: used as recorded");
    return recorded;
  });
  return capsules;
}

PlacedMovement::PlacedMovement(const PlanningInputs& planner, const HumanMotion& motion,
                               const Movement& movement, const Scene& around, const Vec3& offset) {
  const PipelineConfig& config = planner.config;
  const robot::Robot& robot = planner.robot;
  const Pose base_from_world = base_from_motion(planner, motion, movement, offset);
  scene = scene::transform_scene(around, base_from_world);
  const Vec3 shoulder = base_from_world * map::shoulder_at_begin(motion, movement);
  frames = find_world_frames(scene, movement, base_from_world, shoulder);
  missing_support = scene::add_relative_objects(config.scene, frames, movement.begin_s, scene);
  goals = map::make_goals(robot, motion, movement, base_from_world);
  if (config.map.base_offset.limit_m > 0) goals.base_offset = offset;
  mapping_scene = select_mapping_scene(config, scene, movement);
  world = collision::make_world(robot, mapping_scene, movement, config.check.tolerances,
                                config.scene.meshes);
  problem = map::make_mapping_problem(robot, goals, world, config.map, movement.phases);
  problem.reference = planner.reference;
  if (config.map.mode == map::MapMode::joint_to_joint) {
    problem.goals = map::joint_to_joint_goals(robot, motion.hand_angles, motion.time, goals);
  }
}

std::vector<std::size_t> evenly_spaced_indices(std::size_t count, std::size_t max_count) {
  const std::size_t selected = std::min(max_count, count);
  if (selected == 1) return {0};
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < selected; ++k) indices.push_back(k * (count - 1) / (selected - 1));
  return indices;
}

Vec3 choose_offset(const PlanningInputs& planner, const HumanMotion& motion,
                   const Movement& movement, const Scene& around, std::uint64_t seed) {
  const map::MapOptions& options = planner.config.map;
  const PlacedMovement unmoved(planner, motion, movement, around, Vec3::Zero());
  const bool any_goal = std::ranges::any_of(
      unmoved.problem.goals,
      [](const humanlike::FrameGoal& goal) { return goal.goal_tip_count() > 0; });
  if (unmoved.problem.frames() < 5 || !any_goal) return Vec3::Zero();
  const std::vector<std::size_t> frames = evenly_spaced_indices(unmoved.problem.frames(), 16);
  const JointRows without_offset =
      map::search_movement(map::problem_at_frames(unmoved.problem, frames), options, seed)
          .front()
          .q;
  map::MappingScratch scratch;
  const auto cost = [&](const Vec3& offset) {
    const PlacedMovement moved(planner, motion, movement, around, offset);
    double sum = 0;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const JointVector start = without_offset.row(k).transpose();
      sum += map::solve_frame(moved.problem, frames[k], start, options.frame_solver, scratch).value;
    }
    return sum / static_cast<double>(frames.size()) +
           options.base_offset.weight * offset.squaredNorm();
  };
  return map::compass_search(cost, options.base_offset.limit_m, 0.001);
}

}  // namespace morphe::planning
