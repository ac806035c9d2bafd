#pragma once

#include <filesystem>
#include <string>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Reads the triangles of an STL, OBJ, DAE or glTF file, all parts with the transformations of
/// their nodes, in the file's axes and units. Collada's unit and up axis are ignored, as in ROS.
/// Files above 200 MB (four million triangles as STL) are rejected. Returns "" or the error in the
/// file.
std::string load_raw_mesh(const std::filesystem::path& file, SceneObject& mesh);

/// Reads a mesh as an object of the scene, its coordinates multiplied by `scale` to give m.
/// Vertices within a micrometre are merged, and holes narrower than 10 mm are filled
/// (close_holes.hpp). With `hull` it returns the convex hull of the vertices instead (an error if
/// they are coplanar).
std::string load_mesh(const std::filesystem::path& file, double scale, bool hull,
                      SceneObject& mesh);

}  // namespace morphe::collision
