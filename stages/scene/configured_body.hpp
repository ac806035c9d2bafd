#pragma once

#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Returns Rz(yaw) Ry(pitch) Rx(roll).
Quat rotation_from_rpy(const Vec3& rpy);

/// Creates an object in the frame that its pose refers to, with its anchor at `position`.
SceneObject configured_body(const ConfiguredObject& configured, double time_s);

/// Sets shape, size and mesh of `object` to those of a target's body.
void set_shape(const TargetBody& body, SceneObject& object);

}  // namespace morphe::scene
