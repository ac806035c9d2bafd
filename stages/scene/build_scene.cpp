#include "stages/scene/build_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/bounding_box.hpp"
#include "stages/scene/configured_body.hpp"
#include "stages/scene/infer_objects.hpp"

namespace morphe::scene {
namespace {

/// Returns the name of the recorded object whose centre is nearest to the seen tips at the end of
/// the grasp, among those within kMaxTipObjectDistance_m of them that are not part of the other
/// arm; "" if there is no such object.
std::string nearest_object(const SceneOptions& options, const std::vector<SceneObject>& objects,
                           const HumanMotion& motion, const Phase& grasp) {
  const GraspTips tips = tips_at_grasp(motion, grasp);
  Vec3 hand = (tips.thumb + tips.index) / 2;
  if (!is_known(hand)) hand = is_known(tips.thumb) ? tips.thumb : tips.index;
  std::string name;
  double nearest = kInfinity;
  for (const SceneObject& object : objects) {
    if (object.time.empty() || is_other_arm_part(options, object.name)) continue;
    const Pose pose = recorded_pose(object, grasp.end_s);
    const double distance = (pose.translation() - hand).norm();
    const double gap = std::min(distance, bounding_box(object, pose).exteriorDistance(hand));
    if (distance < nearest && gap < kMaxTipObjectDistance_m) {
      nearest = distance;
      name = object.name;
    }
  }
  return name;
}

/// Returns the frame that an object is relative to; unseen if it does not exist.
Pose frame_of(ReferenceFrame relative, const WorldFrames& frames) {
  switch (relative) {
    case ReferenceFrame::table:
      return frames.base_from_table;
    case ReferenceFrame::target:
      return frames.base_from_target;
    case ReferenceFrame::shoulder: {
      Pose shoulder = frames.base_from_world;
      shoulder.translation() = frames.shoulder;
      return shoulder;
    }
    case ReferenceFrame::base:
      return Pose::Identity();
    default:
      return frames.base_from_world;
  }
}

}  // namespace

Scene build_scene(const SceneOptions& options, const Demonstration& demonstration,
                  const HumanMotion& motion, Movement& movement) {
  Scene scene;
  for (const ConfiguredObject* object : configured_objects(options)) {
    if (object->relative_to == ReferenceFrame::world)
      scene.objects.push_back(configured_body(*object, movement.begin_s));
  }
  std::optional<SceneObject> table;
  if (!find_object(demonstration.objects, "table"))
    table = infer_table(options.table, motion, movement);
  if (table) scene.objects.push_back(*table);
  for (const SceneObject& object : demonstration.objects) {
    if (object.time.empty()) continue;
    SceneObject& recorded = scene.objects.emplace_back(object);
    recorded.pose_origin = ObjectOrigin::recorded;
    if (recorded.shape_origin == ObjectOrigin::unknown)
      recorded.shape_origin = ObjectOrigin::recorded;
  }
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  if (!grasp) {
    movement.target.clear();
    return scene;
  }
  if (!find_object(demonstration.objects, movement.target)) {
    movement.target = nearest_object(options, demonstration.objects, motion, *grasp);
    if (movement.target.empty() && find_object(demonstration.objects, options.target.name))
      movement.target = options.target.name;
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
  Scene transformed = scene;
  const Quat rotation(base_from_world.linear());
  for (SceneObject& object : transformed.objects) {
    for (Vec3& position : object.position) position = base_from_world * position;
    for (Quat& quat : object.orientation) quat = (rotation * quat).normalized();
  }
  return transformed;
}

std::string add_relative_objects(const SceneOptions& options, const WorldFrames& frames,
                                 double time_s, Scene& scene) {
  for (const ConfiguredObject* configured : configured_objects(options)) {
    if (configured->relative_to == ReferenceFrame::world) continue;
    const Pose base_from_frame = frame_of(configured->relative_to, frames);
    if (!is_known(base_from_frame)) {
      return fmt::format("{} is placed relative to the {}, which does not exist in this movement",
                         configured->name, name_of(configured->relative_to));
    }
    SceneObject& object = scene.objects.emplace_back(configured_body(*configured, time_s));
    object.position[0] = base_from_frame * object.position[0];
    object.orientation[0] = (Quat(base_from_frame.linear()) * object.orientation[0]).normalized();
  }
  return "";
}

std::vector<std::string> mapping_obstacles(const SceneOptions& options, const Scene& scene) {
  std::vector<std::string> names;
  if (find_object(scene.objects, "table")) names.push_back("table");
  for (const ConfiguredObject* object : configured_objects(options)) {
    if (object->avoid_in_mapping && find_object(scene.objects, object->name))
      names.push_back(object->name);
  }
  return names;
}

}  // namespace morphe::scene
