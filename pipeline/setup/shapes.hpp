#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// The folders of meshes. `package://NAME/…` is resolved in the folder given for NAME, otherwise in
/// the nearest folder above the URDF that contains NAME or the path itself, or is named NAME; a
/// relative path is resolved beside the URDF.
struct PackagePaths {
  /// The folder of each package.
  std::map<std::string, std::filesystem::path> packages;
};

/// The shapes of a URDF's links, ready to be covered: collision shapes, or visual ones for links
/// without collision shapes. Meshes that are missing or cannot be read are named in `notes`, once
/// each.
struct LinkShapes {
  /// The shapes of each frame, in that frame; meshes with their vertices.
  std::map<int, std::vector<SceneObject>> shapes_by_frame;
  /// The points of the shapes, by frame.
  BodyPoints points;
  /// The sentences about missing or unreadable meshes.
  std::vector<std::string> notes;
};
/// Reads the shapes of all links.
LinkShapes read_shapes(const Kinematics& robot, const PackagePaths& places);

}  // namespace morphe::setup
