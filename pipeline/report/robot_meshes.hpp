#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// The visual mesh of a frame: vertices in the frame [m].
struct FrameMesh {
  /// The index of the frame.
  int frame = 0;
  /// The vertices in the frame [m].
  std::vector<Vec3> vertices;
  /// The indices of the vertices of each triangle.
  std::vector<Eigen::Vector3i> triangles;
  /// Name of its block in the page.
  std::string block;
};

/// The meshes of a robot and the problems with them.
struct FoundMeshes {
  /// The meshes that were found.
  std::vector<FrameMesh> meshes;
  /// Sentences about meshes that were not found or could not be read.
  std::vector<std::string> notes;
};

/// Finds meshes of a robot's frames below a folder. From every URDF in it, the visuals of each link
/// are used whose name, or whose joint's name, is that of a frame (package://P/FILE and other names
/// are searched as P/FILE, FILE, and by FILE's own name). For frames without such a link,
/// FRAME.stl, .obj, .dae or .glb is used, in the frame's own axes. Throws InputError if the folder
/// cannot be read.
FoundMeshes find_meshes(const RobotModel& robot, const std::filesystem::path& folder);

}  // namespace morphe::report
