#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/xml_text.hpp"

namespace morphe::robot {

/// How a URDF's joint moves. Planar and floating joints, which nothing can drive, count as fixed.
enum class JointKind { fixed, revolute, continuous, prismatic };

/// A joint of a URDF and where it stands.
struct UrdfJoint {
  std::string name, parent, child;
  JointKind kind = JointKind::fixed;
  std::optional<double> lower, upper, velocity;  ///< as written; a velocity of 0 is none
  const files::XmlElement* element = nullptr;
};

struct UrdfTree {
  std::string root;                ///< the link that hangs on nothing
  std::vector<UrdfJoint> joints;   ///< in the file's order, moved behind their parents
  std::vector<std::string> notes;  ///< "FILE:LINE: …": what was left out or simplified
};

/// The numbers of an attribute; empty if anything in it is none, or not finite.
std::vector<double> numbers_of(const std::string& text);

/// A file with more is not read: the largest public ones have a few hundred.
inline constexpr std::size_t kMostLinks = 4096;

/// Throws one InputError of all that is wrong: a link or joint that stands twice or has no name, a
/// joint whose links do not exist, a link with two parents, a loop, more than one root, an unknown
/// type, a zero axis, limits that are crossed, numbers that are none, more than kMostLinks links,
/// a file that is still xacro.
UrdfTree urdf_tree(const files::XmlText& urdf);

}  // namespace morphe::robot
