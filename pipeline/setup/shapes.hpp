#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/mesh_paths.hpp"

namespace morphe::setup {

/// The shapes of a URDF's links: collision shapes, or else visual ones.
struct LinkShapes {
  std::map<int, std::vector<SceneObject>> shapes_by_frame;  ///< in the frame of their key
  BodyPoints points;                                        ///< of the shapes, by frame
  /// On meshes that are missing, damaged or found elsewhere: one for each package and kind of
  /// problem.
  std::vector<std::string> notes;
};
/// Reads the shapes of all links. Shapes that cannot be read are left out with a note.
LinkShapes read_shapes(const Kinematics& robot, const PackagePaths& places);

}  // namespace morphe::setup
