#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/node.hpp"
#include "core/moveit/problem.hpp"

namespace morphe::moveit {

/// Parts of MoveIt's messages. Every function fails with the node's place.

/// [x, y, z] or {x, y, z}.
Vec3 read_vector(const config::ConfigNode& node);
/// [x, y, z, w] or {x, y, z, w}; all zero counts as no rotation, as in MoveIt.
Quat read_rotation(const config::ConfigNode& node);
/// {position, orientation}; either may be missing.
Pose read_pose(const config::ConfigNode& node);
/// {translation, rotation}.
Pose read_transform(const config::ConfigNode& node);
/// The key's items, none if it is missing.
std::vector<config::ConfigNode> items_of(const config::ConfigNode& node, const char* key);
/// Fails if the key holds anything: a list or mapping with entries.
void refuse(const config::ConfigNode& node, const char* key, const char* why);

/// base_from_frame of {header: {frame_id}}, by name; "" is the world.
struct Frames {
  std::map<std::string, Pose> base_from;
  Pose of(const config::ConfigNode& owner) const;
};
Frames read_frames(const config::ConfigNode& scene, const std::string& root_link,
                   const Pose& base_from_world);

/// {type, dimensions} at base_from_shape: size checked, time 0.
SceneObject read_primitive(const config::ConfigNode& node, const Pose& base_from_shape);
/// {primitives, primitive_poses, meshes, mesh_poses} at base_from_owner. None: fails.
std::vector<SceneObject> read_shapes(const config::ConfigNode& owner, const Pose& base_from_owner);
/// world.collision_objects.
Scene read_objects(const config::ConfigNode& scene, const Frames& frames);

/// goal_constraints of a request.
std::vector<PlanningGoal> read_goals(const config::ConfigNode& request,
                                     const robot::RobotDescription& robot, const Frames& frames);

}  // namespace morphe::moveit
