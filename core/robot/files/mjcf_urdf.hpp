#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/robot/files/mjcf_model.hpp"

namespace morphe::robot {

/// An MJCF's robot as URDF.
struct MjcfUrdf {
  std::string text;
  /// The pose of each body in its link, by name. It differs from the identity by the anchor of the
  /// body's last hinge, because a URDF's hinge is at the origin of its link.
  std::map<std::string, Pose> link_from_body;
  /// The pose of the root link in the MJCF's world: that of the only body below the world, if it
  /// has no joint; otherwise the root link is "world".
  Pose world_from_root = Pose::Identity();
};

/// Writes a robot as URDF that will be in `folder`, to which paths of meshes are relative. Bodies
/// and named sites are links; a body with several joints has a massless link for each further one.
/// A capsule is a cylinder with a sphere at each end. Velocities are 0, because an MJCF has none.
MjcfUrdf urdf_of(const MjcfModel& model, const std::filesystem::path& folder);

/// Returns true if a file's text was written by urdf_of(MjcfModel).
bool is_converted_mjcf(const std::string& text);

}  // namespace morphe::robot
