#include "stages/scene/build_scene.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/motion/extent.hpp"
#include "stages/scene/configured_body.hpp"
#include "stages/scene/inferred.hpp"
#include "stages/scene/other_arm.hpp"

namespace morphe::scene {
namespace {

constexpr double kInReach = 0.15;  ///< between the tips and an object that they took [m]

/// Name of the recorded object whose centre is nearest to the seen tips at the end of the grasp, of
/// those that are not farther than kInReach from them, nor of the other arm; "" if there is none.
std::string nearest_object(const SceneOptions& options, const std::vector<SceneObject>& objects,
                           const HumanMotion& motion, const Phase& grasp) {
  const GraspTips tips = tips_at_grasp(motion, grasp);
  Vec3 hand = (tips.thumb + tips.index) / 2;
  if (!seen(hand)) hand = seen(tips.thumb) ? tips.thumb : tips.index;
  std::string name;
  double least = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : objects) {
    if (object.time.empty() || of_other_arm(options, object.name)) continue;
    const Pose pose = recorded_pose(object, grasp.end_s);
    const double distance = (pose.translation() - hand).norm();
    const double apart = std::min(distance, extent_of(object, pose).exteriorDistance(hand));
    if (distance < least && apart < kInReach) {
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
      if (object.relative_to != Relative::world) continue;
      scene.objects.push_back(configured_body(object, movement.begin_s));
    }
  }
  std::optional<SceneObject> table;
  if (!object_named(demonstration.objects, "table")) {
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
  if (!object_named(demonstration.objects, movement.target)) {
    movement.target = nearest_object(options, demonstration.objects, motion, *grasp);
    if (movement.target.empty() && object_named(demonstration.objects, options.target.name)) {
      movement.target = options.target.name;
    }
  }
  for (SceneObject& object : scene.objects) {
    if (object.name != movement.target) continue;
    set_carrying(movement, *grasp, object);
    if (options.target.body) take_shape(*options.target.body, object);
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

Scene move_scene(const Scene& scene, const Pose& base_from_world) {
  Scene moved = scene;
  const Quat turn(base_from_world.linear());
  for (SceneObject& object : moved.objects) {
    for (Vec3& position : object.position) position = base_from_world * position;
    for (Quat& orientation : object.orientation) orientation = (turn * orientation).normalized();
  }
  return moved;
}

std::vector<std::string> mapping_objects(const SceneOptions& options, const Scene& scene) {
  std::vector<std::string> names;
  if (object_named(scene.objects, "table")) names.push_back("table");
  for (const auto* list : {&options.objects, &options.file_objects}) {
    for (const ConfiguredObject& object : *list) {
      if (object.in_mapping && object_named(scene.objects, object.name)) {
        names.push_back(object.name);
      }
    }
  }
  return names;
}

}  // namespace morphe::scene
