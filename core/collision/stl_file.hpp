#pragma once

#include <filesystem>
#include <string>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Reads the triangles of an STL file, text or binary, in the file's order. Each triangle has
/// vertices of its own, rounded to single precision. Returns the error in the file, with its line
/// for a text file, or "" if vertices and triangles were filled.
std::string read_stl(const std::filesystem::path& file, SceneObject& mesh);

}  // namespace morphe::collision
