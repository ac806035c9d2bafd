#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// The visual mesh of a frame: vertices in the frame [m].
struct FrameMesh {
  int frame = 0;
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;  ///< indices of vertices
  std::string block;                       ///< name of its block in the page
};

/// The meshes of a robot and the problems with them.
struct FoundMeshes {
  std::vector<FrameMesh> meshes;
  std::vector<std::string> notes;  ///< about meshes that were not found or could not be read
};

/// Finds meshes of a robot's frames below a folder.
///   1. From the URDFs in it, those visuals are used whose link, or the joint that moves it, has
///   the
///      name of a frame. The first URDF with a name counts. A mesh package://P/DIR/FILE is searched
///      as P/DIR/FILE, then as DIR/FILE, then as FILE.
///   2. For other frames, FRAME.stl, .obj, .dae and .glb are used, in the frame's own axes.
/// Throws InputError if the folder cannot be read.
FoundMeshes find_meshes(const RobotModel& robot, const std::filesystem::path& folder);

}  // namespace morphe::report
