#include "core/motion/find_world_frames.hpp"

namespace morphe {

std::optional<Pose> box_top_pose(const SceneObject& box, double time_s) {
  if (box.shape != Shape::box) return std::nullopt;
  return recorded_pose(box, time_s) * Eigen::Translation3d(0, 0, box.size[2] / 2);
}

WorldFrames find_world_frames(const Scene& scene, const Movement& movement,
                              const Pose& base_from_world, const Vec3& shoulder_in_base) {
  WorldFrames frames;
  frames.base_from_world = base_from_world;
  frames.shoulder = shoulder_in_base;
  if (const SceneObject* table = find_object(scene.objects, "table"))
    frames.base_from_table = box_top_pose(*table, movement.begin_s).value_or(unknown_pose());
  if (const SceneObject* target = find_object(scene.objects, movement.target))
    frames.base_from_target = recorded_pose(*target, movement.begin_s);
  return frames;
}

}  // namespace morphe
