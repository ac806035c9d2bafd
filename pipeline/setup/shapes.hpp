#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Where meshes are: `package://NAME/…` in the folder given for NAME, else in the nearest folder
/// above the URDF that has NAME (or is called so); a relative path beside the URDF.
struct MeshPlaces {
  std::map<std::string, std::filesystem::path> packages;
};

/// The shapes of a URDF's links, ready to be covered: collision shapes, or visual ones where a link
/// has no other. Meshes that are missing or cannot be read are named in `notes`, once each.
struct LinkShapes {
  std::map<int, std::vector<SceneObject>> of_frame;  ///< in the frame; vertices of meshes as well
  BodyPoints points;
  std::vector<std::string> notes;
};
LinkShapes read_shapes(const Kinematics& robot, const MeshPlaces& places);

}  // namespace morphe::setup
