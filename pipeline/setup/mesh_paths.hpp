#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace morphe::setup {

/// The folders of packages, given by the user.
struct PackagePaths {
  std::map<std::string, std::filesystem::path> packages;
};

/// The place at which the file of a mesh was searched.
struct MeshPlace {
  std::filesystem::path file;  ///< "" if it was not found
  std::string package;         ///< NAME, "" if the URDF names none
  bool by_tail = false;        ///< found only after leading folders of its path were dropped
};

/// Finds the file of a mesh that a URDF names. `package://NAME/PATH` (also `model://NAME/PATH` and
/// `$(find NAME)/PATH`) is PATH in the folder given for NAME; otherwise, in the nearest folder F
/// above the URDF that has it, PATH in F (if F is called NAME), F/NAME, F/src/NAME, F/share/NAME or
/// F. Other relative paths begin at the folder of the URDF. If the file is not there, leading
/// folders of PATH are dropped until F/PATH exists.
MeshPlace find_mesh(const std::filesystem::path& urdf, const std::string& name,
                    const PackagePaths& places);

}  // namespace morphe::setup
