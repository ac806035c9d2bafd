#pragma once

#include <string>
#include <vector>

#include "pipeline/files/xml_text.hpp"

namespace morphe::robot {

/// A joint of a URDF and where it stands.
struct UrdfJoint {
  std::string name, parent, child;
  const files::XmlElement* element = nullptr;
};

/// The joints in the file's order, moved behind their parents where they stand before them. Throws
/// InputError for a link or joint that stands twice or has no name, a joint whose links do not
/// exist, a link with two parents, a loop, more than one root, a joint that is not revolute,
/// continuous or fixed, a zero axis, and limits that are missing or crossed.
std::vector<UrdfJoint> urdf_joints(const files::XmlText& urdf);

}  // namespace morphe::robot
