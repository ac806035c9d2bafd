#pragma once

#include "core/motion/scene.hpp"

namespace morphe {

/// Returns the bounding box of an object along the axes of the frame that `frame_from_object` leads
/// to. It is the object's centre alone if the number of dimensions does not fit the shape.
Eigen::AlignedBox3d bounding_box(const SceneObject& object, const Pose& frame_from_object);

}  // namespace morphe
