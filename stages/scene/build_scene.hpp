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
/// in this order. A recorded "table" replaces the inferred table. Without a grasp,
/// `movement.target` becomes "". Otherwise it becomes the first of these that exists:
///   the recorded object that it names already
///   the nearest of the recorded objects within 0.15 m of the tips at the grasp (an object farther
///   away was not taken by the hand), except parts of the other arm
///   the recorded object called options.target.name
///   the inferred target, see infer_target()
/// A recorded target gets the shape options.target.body, if there is one. attach_s and release_s of
/// the target are set; the caller chooses the robot frame to which it is attached.
Scene build_scene(const SceneOptions& options, const Demonstration& demonstration,
                  const HumanMotion& motion, Movement& movement);

/// Returns the scene in the frame of the base.
Scene transform_scene(const Scene& scene, const Pose& base_from_world);

/// Adds the configured objects that are relative to a frame other than the world, with their poses
/// at `time_s`, to a scene in the frame of the base. Returns a sentence about the first object
/// whose reference frame does not exist, which ends the addition, or "".
std::string add_relative_objects(const SceneOptions& options, const WorldFrames& frames,
                                 double time_s, Scene& scene);

/// Returns the names of the objects from which the mapping keeps clear: "table" and the configured
/// objects with `avoid_in_mapping`, if the scene contains them.
std::vector<std::string> mapping_obstacles(const SceneOptions& options, const Scene& scene);

}  // namespace morphe::scene
