#pragma once

#include <filesystem>
#include <string>

#include "pipeline/motion/scene.hpp"

namespace morphe::collision {

/// Reads an STL or OBJ file into vertices and triangles of a mesh, in the file's axes, its numbers
/// times `scale` = m. Vertices within a micrometre become one,
/// and holes narrower than 10 mm get a lid (close_holes.hpp). `hull`: the convex hull of its
/// vertices instead (of nothing flat). Returns "" or what is wrong with the file.
std::string load_mesh(const std::filesystem::path& file, double scale, bool hull,
                      SceneObject& mesh);

}  // namespace morphe::collision
