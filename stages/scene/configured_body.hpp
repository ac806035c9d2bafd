#pragma once

#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Returns Rz(yaw) Ry(pitch) Rx(roll) of (roll, pitch, yaw) [rad].
Quat rotation_from_rpy(const Vec3& rpy);

/// Returns an object with one pose, at `time_s`, in the frame `configured.relative_to`; its anchor
/// is at `configured.position`.
SceneObject configured_body(const ConfiguredObject& configured, double time_s);

/// Sets shape, size and mesh of `object` to those of a target's body.
void set_shape(const TargetBody& body, SceneObject& object);

}  // namespace morphe::scene
