#pragma once

#include <optional>

#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/world_frames.hpp"

namespace morphe {

/// Centre of the top of a box, with its axes. Nothing for another shape.
std::optional<Pose> top_of_box(const SceneObject& box, double time_s);

/// Of a scene in the base's frame: its object "table" and what `movement.target` names, both at
/// the movement's begin.
WorldFrames world_frames(const Scene& scene, const Movement& movement, const Pose& base_from_world,
                         const Vec3& shoulder_in_base);

}  // namespace morphe
