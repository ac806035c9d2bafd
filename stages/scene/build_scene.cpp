#include "stages/scene/build_scene.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/motion/bounding_box.hpp"
#include "stages/scene/configured_body.hpp"
#include "stages/scene/infer_objects.hpp"
#include "stages/scene/other_arm.hpp"

namespace morphe::scene {
namespace {

/// Largest distance between the tips and the object that they took [m].
constexpr double kMaxTipObjectDistance_m = 0.15;

/// Returns the name of the recorded object whose centre is nearest to the seen tips at the end of
/// the grasp, among those within kMaxTipObjectDistance_m of them that are not part of the other
/// arm; "" if there is no such object.
std::string nearest_object(const SceneOptions& options, const std::vector<SceneObject>& objects,
                           const HumanMotion& motion, const Phase& grasp) {
  const GraspTips tips = tips_at_grasp(motion, grasp);
  Vec3 hand = (tips.thumb + tips.index) / 2;
  if (!is_known(hand)) hand = is_known(tips.thumb) ? tips.thumb : tips.index;
  std::string name;
  double least = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : objects) {
    if (object.time.empty() || is_other_arm_part(options, object.name)) continue;
    const Pose pose = recorded_pose(object, grasp.end_s);
    const double distance = (pose.translation() - hand).norm();
    const double apart = std::min(distance, bounding_box(object, pose).exteriorDistance(hand));
    if (distance < least && apart < kMaxTipObjectDistance_m) {
      least = distance;
      name = object.name;
    }
  }
  return name;
}

}  // namespace

Scene build_scene(const SceneOptions& options, const Demonstration& demonstration,
                  const HumanMotion& motion, Movement& movement) {
  Scene scene;
  for (const auto* list : {&options.objects, &options.file_objects}) {
    for (const ConfiguredObject& object : *list) {
      if (object.relative_to != ReferenceFrame::world) continue;
      scene.objects.push_back(configured_body(object, movement.begin_s));
    }
  }
  std::optional<SceneObject> table;
  if (!find_object(demonstration.objects, "table")) {
    table = infer_table(options.table, motion, movement);
  }
  if (table) scene.objects.push_back(*table);
  for (const SceneObject& object : demonstration.objects) {
    if (!object.time.empty()) scene.objects.push_back(object);
  }
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  if (!grasp) {
    movement.target.clear();
    return scene;
  }
  if (!find_object(demonstration.objects, movement.target)) {
    movement.target = nearest_object(options, demonstration.objects, motion, *grasp);
    if (movement.target.empty() && find_object(demonstration.objects, options.target.name)) {
      movement.target = options.target.name;
    }
  }
  for (SceneObject& object : scene.objects) {
    if (object.name != movement.target) continue;
    set_attachment_times(movement, *grasp, object);
    if (options.target.body) set_shape(*options.target.body, object);
  }
  if (!movement.target.empty()) return scene;
  const std::optional<SceneObject> target =
      infer_target(options.target, motion, movement, table ? &*table : nullptr);
  if (target) {
    movement.target = target->name;
    scene.objects.push_back(*target);
  }
  return scene;
}

Scene transform_scene(const Scene& scene, const Pose& base_from_world) {
  Scene moved = scene;
  const Quat turn(base_from_world.linear());
  for (SceneObject& object : moved.objects) {
    for (Vec3& position : object.position) position = base_from_world * position;
    for (Quat& orientation : object.orientation) orientation = (turn * orientation).normalized();
  }
  return moved;
}

std::vector<std::string> mapping_obstacles(const SceneOptions& options, const Scene& scene) {
  std::vector<std::string> names;
  if (find_object(scene.objects, "table")) names.push_back("table");
  for (const auto* list : {&options.objects, &options.file_objects}) {
    for (const ConfiguredObject& object : *list) {
      if (object.avoid_in_mapping && find_object(scene.objects, object.name)) {
        names.push_back(object.name);
      }
    }
  }
  return names;
}

}  // namespace morphe::scene
