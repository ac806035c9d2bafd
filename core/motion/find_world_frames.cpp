#include "core/motion/find_world_frames.hpp"

namespace morphe {

std::optional<Pose> top_of_box(const SceneObject& box, double time_s) {
  if (box.shape != Shape::box) return std::nullopt;
  return recorded_pose(box, time_s) * Eigen::Translation3d(0, 0, box.size[2] / 2);
}

WorldFrames world_frames(const Scene& scene, const Movement& movement, const Pose& base_from_world,
                         const Vec3& shoulder_in_base) {
  WorldFrames frames;
  frames.base_from_world = base_from_world;
  frames.shoulder = shoulder_in_base;
  if (const SceneObject* table = object_named(scene.objects, "table"))
    frames.base_from_table = top_of_box(*table, movement.begin_s).value_or(unseen_pose());
  if (const SceneObject* target = object_named(scene.objects, movement.target))
    frames.base_from_target = recorded_pose(*target, movement.begin_s);
  return frames;
}

}  // namespace morphe
