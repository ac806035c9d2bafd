#pragma once

#include <optional>

#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/world_frames.hpp"

namespace morphe {

/// Returns the pose of the centre of a box's top face, with the axes of the box, or nullopt if the
/// object is not a box.
std::optional<Pose> box_top_pose(const SceneObject& box, double time_s);

/// Computes the reference frames of a scene given in the base frame, from its object "table" and
/// the object named by `movement.target`, both at the begin of the movement.
WorldFrames find_world_frames(const Scene& scene, const Movement& movement,
                              const Pose& base_from_world, const Vec3& shoulder_in_base);

}  // namespace morphe
