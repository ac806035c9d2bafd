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
/// Reads {translation, rotation}.
Pose read_transform(const config::ConfigNode& node);
/// Returns the items of a key, an empty list if it is missing.
std::vector<config::ConfigNode> items_of(const config::ConfigNode& node, const char* key);
/// Throws if the key has content: a list or mapping with entries.
void refuse(const config::ConfigNode& node, const char* key, const char* why);

/// The poses base_from_frame of the frames in {header: {frame_id}}, by name; "" is the world.
struct FixedFrames {
  std::map<std::string, Pose> base_from;
  /// Returns the pose of the frame that a message names in its header; throws if it is unknown.
  Pose pose_of(const config::ConfigNode& owner) const;
};
/// Reads the fixed frames of a scene.
FixedFrames read_frames(const config::ConfigNode& scene, const std::string& root_link,
                        const Pose& base_from_world);

/// Reads {type, dimensions} at base_from_shape, with checked size and time 0.
SceneObject read_primitive(const config::ConfigNode& node, const Pose& base_from_shape);
/// Reads {primitives, primitive_poses, meshes, mesh_poses} at base_from_owner; throws if there are
/// no shapes.
std::vector<SceneObject> read_shapes(const config::ConfigNode& owner, const Pose& base_from_owner);
/// Reads world.collision_objects.
Scene read_objects(const config::ConfigNode& scene, const FixedFrames& frames);

}  // namespace morphe::moveit
