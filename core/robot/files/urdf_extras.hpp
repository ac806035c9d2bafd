#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::robot {

/// The data of a URDF's link and joint that RobotModel does not hold.
struct UrdfExtra {
  std::string link, joint;    ///< prefixed names in the URDF, "" if not in a URDF
  std::string link_elements;  ///< visual, collision and inertial elements, one per line
  bool has_visual = false, has_collision = false, has_inertial = false;
  std::optional<double> effort;  ///< above 0
  std::string dynamics;          ///< the dynamics element, "" if absent
  bool continuous = false;
};

/// Returns the extra data [frames], with empty entries for frames that are not from a URDF. Paths
/// of meshes and textures relative to a URDF are made relative to `folder`. References to named
/// materials are replaced by their definitions. Throws InputError as load_robot() does.
std::vector<UrdfExtra> urdf_extras(const RobotDescription& robot,
                                   const std::filesystem::path& folder);

/// Returns a sentence for each kind of data (efforts, inertias, visuals) that is missing for some
/// links or joints.
std::vector<std::string> missing_details(const RobotModel& robot,
                                         const std::vector<UrdfExtra>& extras);

}  // namespace morphe::robot
