#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/world_frames.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Builds the scene around one movement in the world frame: the configured objects that are
/// relative to the world, "table", the recorded objects with their motion, and the inferred target,
/// in this order. Sets `movement.target` if the movement has a grasp: to the recorded object that
/// it already names; otherwise to the recorded object nearest to the tips at the grasp, if it is
/// within 0.15 m of them (an object farther away was not taken by the hand) or has the name of the
/// inferred target; otherwise to the inferred cylinder; otherwise to "" (tips not seen). Parts of
/// the other arm among the recorded objects are never the target. A recorded "table" replaces the
/// inferred table. attach_s and release_s of the target span the carrying (end of the grasp to the
/// end of the last transport); the caller chooses the robot frame to which it is attached.
Scene build_scene(const SceneOptions& options, const Demonstration& demonstration,
                  const HumanMotion& motion, Movement& movement);

/// Returns the scene transformed to another frame.
Scene transform_scene(const Scene& scene, const Pose& base_from_world);

/// Adds the configured objects that are relative to a frame other than the world; all are in the
/// frame of the base. Returns a sentence about the first object whose reference frame does not
/// exist, or "".
std::string add_relative_objects(const SceneOptions& options, const WorldFrames& frames,
                                 double time_s, Scene& scene);

/// Returns the names of the objects from which the mapping keeps clear: the table and the
/// configured objects with `avoid_in_mapping`, but never the target.
std::vector<std::string> mapping_obstacles(const SceneOptions& options, const Scene& scene);

}  // namespace morphe::scene
