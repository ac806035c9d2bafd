#pragma once

#include "core/motion/scene.hpp"

namespace morphe {

/// Returns the axis-aligned bounding box of an object in the frame in which `frame_from_object`
/// gives its pose. If the object has no size, or a number of dimensions that does not fit its
/// shape, the box is the point at its centre.
Eigen::AlignedBox3d bounding_box(const SceneObject& object, const Pose& frame_from_object);

}  // namespace morphe
