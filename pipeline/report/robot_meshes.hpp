#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::report {

/// What a frame looks like: corners in the frame [m].
struct FrameMesh {
  int frame = 0;
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::string block;  ///< of the page
};

struct FoundMeshes {
  std::vector<FrameMesh> meshes;
  std::vector<std::string> notes;  ///< what was not found or could not be read
};

/// Meshes of a robot's frames below a folder: of every URDF there the visuals of each link whose
/// name, or whose joint's name, a frame has (package://P/FILE and other names are looked for as
/// P/FILE, FILE and by FILE's own name); and of frames that none of them has FRAME.stl, .obj, .dae
/// or .glb, in the frame's own axes. InputError if the folder cannot be read.
FoundMeshes find_meshes(const RobotTable& robot, const std::filesystem::path& folder);

}  // namespace morphe::report
