#pragma once

#include "core/motion/scene.hpp"

namespace morphe {

/// The smallest box along a frame's axes that holds an object; `frame_from_object` places it there.
/// One without a size, or without the numbers that its shape has, is the point at its centre.
Eigen::AlignedBox3d extent_of(const SceneObject& object, const Pose& frame_from_object);

}  // namespace morphe
