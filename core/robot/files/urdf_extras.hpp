#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// What a URDF says of a frame, and a table does not.
struct UrdfExtra {
  std::string link, joint;  ///< their names; "": the frame's
  std::string body;         ///< visual, collision and inertial elements, a line each
  bool looks = false, shaped = false, massive = false;  ///< which of them there are
  std::optional<double> effort;                         ///< above 0
  std::string dynamics;                                 ///< the element, "" without
  bool continuous = false;
};

/// [frames] of the robot's URDFs, all empty for a robot that has none. Mesh and texture files that
/// are named relative to a URDF are named relative to `folder`; a material that a visual only names
/// is given in full. InputError if a URDF cannot be read any more.
std::vector<UrdfExtra> urdf_extras(const RobotDescription& robot,
                                   const std::filesystem::path& folder);

/// Of whose efforts, inertias and visuals nothing is known, a sentence each.
std::vector<std::string> unknown_of(const RobotTable& robot, const std::vector<UrdfExtra>& extras);

}  // namespace morphe::robot
