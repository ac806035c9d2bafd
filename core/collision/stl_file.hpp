#pragma once

#include <filesystem>
#include <string>

#include "core/motion/scene.hpp"

namespace morphe::collision {

/// The triangles of an STL file, text or binary, in its order; each has corners of its own, rounded
/// to single precision. Returns what is wrong with the file, with its line where it is a text, ""
/// if nothing is; then vertices and triangles are filled.
std::string read_stl(const std::filesystem::path& file, SceneObject& mesh);

}  // namespace morphe::collision
