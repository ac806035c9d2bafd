#pragma once

#include <filesystem>
#include <string>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Reads the triangles of an STL, OBJ, DAE or glTF file, all parts where their nodes put them, in
/// the file's axes and units. What Collada says of its unit and of which way is up is ignored, as
/// in ROS. Files above 200 MB (four million triangles as STL) are refused. Returns "" or what is
/// wrong with the file.
std::string load_surface(const std::filesystem::path& file, SceneObject& mesh);

/// The same as a body of the world, its numbers times `scale` = m: vertices within a micrometre
/// become one, and holes narrower than 10 mm get a lid (close_holes.hpp). `hull`: the convex hull
/// of its vertices instead (of nothing flat).
std::string load_mesh(const std::filesystem::path& file, double scale, bool hull,
                      SceneObject& mesh);

}  // namespace morphe::collision
