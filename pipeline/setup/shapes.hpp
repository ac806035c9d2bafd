#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// The folders of packages. `package://NAME/PATH` names PATH in the folder given for NAME,
/// otherwise PATH or NAME/PATH in the nearest folder above the URDF that contains it. Other
/// relative paths begin at the folder of the URDF.
struct PackagePaths {
  std::map<std::string, std::filesystem::path> packages;
};

/// The shapes of a URDF's links: collision shapes, or else visual ones.
struct LinkShapes {
  std::map<int, std::vector<SceneObject>> shapes_by_frame;  ///< in the frame of their key
  BodyPoints points;                                        ///< of the shapes, by frame
  std::vector<std::string> notes;  ///< one on each mesh that is missing or cannot be read
};
/// Reads the shapes of all links. Shapes that cannot be read are left out with a note.
LinkShapes read_shapes(const Kinematics& robot, const PackagePaths& places);

}  // namespace morphe::setup
