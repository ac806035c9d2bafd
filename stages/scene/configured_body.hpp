#pragma once

#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Rz(yaw) Ry(pitch) Rx(roll).
Quat turn_of(const Vec3& rpy);

/// An object in the frame that its place is given in: position = that of its anchor.
SceneObject configured_body(const ConfiguredObject& configured, double time_s);

/// Shape, size and mesh of a target's body.
void take_shape(const TargetBody& body, SceneObject& object);

}  // namespace morphe::scene
