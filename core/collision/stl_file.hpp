#pragma once

#include <filesystem>
#include <string>

#include "core/files/given_files.hpp"
#include "core/motion/scene.hpp"

namespace morphe::collision {

/// Adds the triangles of an STL file, text or binary, to an empty mesh, in the file's order. Each
/// triangle has vertices of its own, rounded to single precision. Returns the error in the file,
/// with its line if the file is text, or "". Throws InputError if it cannot be read.
std::string read_stl(const std::filesystem::path& file, SceneObject& mesh,
                     const files::GivenFiles* given = nullptr);

}  // namespace morphe::collision
