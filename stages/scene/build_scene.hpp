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

/// The bodies around one movement, in the world frame: configured objects that are relative to the
/// world, then "table", then recorded objects with their motion, then the inferred target. Sets
/// `movement.target` if the movement has a grasp: to the recorded object that it names already,
/// else to the recorded object nearest to the tips at the grasp, if it is within 0.15 m of them
/// (one that stands farther away is not what the hand took) or is called as the inferred one would
/// be, else to the inferred cylinder, else "" (tips not seen). What is of the other arm, among the
/// recorded objects, never is the target. A recorded "table" is the table. The
/// cylinder's attach_s and release_s span the carrying (end of the grasp to the end of the last
/// transport); which robot frame carries it is the caller's business.
Scene build_scene(const SceneOptions& options, const Demonstration& demonstration,
                  const HumanMotion& motion, Movement& movement);

/// The same scene seen from another frame.
Scene move_scene(const Scene& scene, const Pose& base_from_world);

/// Adds the configured objects that are relative to something else than the world; all in the
/// base's frame. Where that is not there: a sentence, which names the first such object; else "".
std::string add_relative_objects(const SceneOptions& options, const WorldFrames& frames,
                                 double time_s, Scene& scene);

/// Names of the objects that the mapping keeps clear of: the table and the configured objects with
/// `in_mapping`; never the target.
std::vector<std::string> mapping_objects(const SceneOptions& options, const Scene& scene);

}  // namespace morphe::scene
