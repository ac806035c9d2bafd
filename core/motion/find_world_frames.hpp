#pragma once

#include <optional>

#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/world_frames.hpp"

namespace morphe {

/// Returns the pose of a box's top face at a time: its centre, the box's axes; nullopt if no box.
std::optional<Pose> box_top_pose(const SceneObject& box, double time_s);

/// Computes the frames at the begin of a movement, from a scene in the base frame: the table is its
/// object "table", the target its object `movement.target`; frames of missing objects are NaN.
WorldFrames find_world_frames(const Scene& scene, const Movement& movement,
                              const Pose& base_from_world, const Vec3& shoulder_in_base);

}  // namespace morphe
