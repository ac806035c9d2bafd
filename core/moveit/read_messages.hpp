#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/node.hpp"
#include "core/motion/scene.hpp"

namespace morphe::moveit {

/// The functions below read parts of MoveIt's messages. Errors contain the location of the node.

/// Reads [x, y, z] or {x, y, z}.
Vec3 read_vector(const config::ConfigNode& node);
/// Reads [x, y, z, w] or {x, y, z, w}; all zero counts as the identity, as in MoveIt.
Quat read_rotation(const config::ConfigNode& node);
/// Reads {position, orientation}; either may be missing.
Pose read_pose(const config::ConfigNode& node);
/// Reads {translation, rotation}; either may be missing.
Pose read_transform(const config::ConfigNode& node);
/// Returns the items of a key, an empty list if it is missing.
std::vector<config::ConfigNode> items_of(const config::ConfigNode& node, const char* key);
/// Throws an error that says `why` if the key has a value other than an empty list, map or text.
void refuse(const config::ConfigNode& node, const char* key, const char* why);

/// The poses base_from_frame of fixed frames, by the name in a message's {header: {frame_id}}.
struct FixedFrames {
  std::map<std::string, Pose> base_from;
  /// Returns the pose of the frame in a message's header, the world's without one; or throws.
  Pose pose_of(const config::ConfigNode& owner) const;
};
/// Reads `fixed_frame_transforms`. The world has the pose base_from_world; root_link, unless it is
/// "", is the base.
FixedFrames read_frames(const config::ConfigNode& scene, const std::string& root_link,
                        const Pose& base_from_world);

/// Reads {type, dimensions}, with all dimensions above 0, as an object that stands still.
SceneObject read_primitive(const config::ConfigNode& node, const Pose& base_from_shape);
/// Reads {primitives, primitive_poses, meshes, mesh_poses}, at least one shape, at base_from_owner.
std::vector<SceneObject> read_shapes(const config::ConfigNode& owner, const Pose& base_from_owner);
/// Reads world.collision_objects.
Scene read_objects(const config::ConfigNode& scene, const FixedFrames& frames);

}  // namespace morphe::moveit
