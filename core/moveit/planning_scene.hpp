#pragma once

#include <filesystem>

#include "core/files/given_files.hpp"
#include "core/motion/scene.hpp"

namespace morphe::moveit {

/// Reads the objects of a MoveIt planning scene (moveit_msgs/PlanningScene) from YAML, in the
/// scene's world frame. Objects can be boxes, spheres, cylinders and explicit meshes, with several
/// shapes each ("shelf", "shelf_2", ...). Numbers are in m, quaternions x, y, z, w. Throws
/// InputError with file, line and key for entries that cannot be read or that would change the
/// scene: an unknown or missing shape, a frame that does not exist, planes, an octomap.
Scene read_moveit_scene(const std::filesystem::path& scene_file,
                        const files::GivenFiles* given = nullptr);

}  // namespace morphe::moveit
