#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/given_files.hpp"
#include "core/motion/scene.hpp"

namespace morphe::collision {

/// The place from which meshes are read, and the files that were read.
struct MeshSource {
  const files::GivenFiles* given = nullptr;  ///< nullptr: the disk
  std::vector<std::filesystem::path> read;   ///< appended: each mesh, then the files that it names
};

/// Reads the triangles of an STL, OBJ, DAE or glTF file in the file's axes and units, all parts
/// with the transformations of their nodes. Collada's unit and up axis are ignored, as in ROS.
/// Files above 200 MB (four million triangles as STL) are rejected. Returns the error with the
/// file, or "".
std::string load_raw_mesh(const std::filesystem::path& named, SceneObject& mesh,
                          MeshSource* source = nullptr);

/// Reads a mesh as load_raw_mesh() does, and multiplies its coordinates by `scale` to give m. With
/// `hull` it is replaced by its convex hull; flat meshes are then an error. Vertices within a
/// micrometre are merged, and holes narrower than 10 mm are filled (close_holes.hpp). Returns the
/// error with the file, or "".
std::string load_mesh(const std::filesystem::path& file, double scale, bool hull, SceneObject& mesh,
                      MeshSource* source = nullptr);

/// Replaces a mesh by the convex hull of its vertices. If the vertices are coplanar or fewer than
/// four, it returns false and leaves the mesh as it is.
bool replace_by_convex_hull(SceneObject& mesh);

}  // namespace morphe::collision
