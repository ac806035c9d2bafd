#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/xml_text.hpp"

namespace morphe::robot {

/// The kind of motion of a URDF's joint. Planar and floating joints, which cannot be driven, count
/// as fixed.
enum class JointKind { fixed, revolute, continuous, prismatic };

/// A joint of a URDF and its element in the file.
struct UrdfJoint {
  std::string name, parent, child;
  JointKind kind = JointKind::fixed;
  std::optional<double> lower, upper, velocity;  ///< as written; absent if a velocity is 0
  const files::XmlElement* element = nullptr;
};

/// The joints of a URDF, in topological order.
struct UrdfTree {
  std::string root;                ///< the link without a parent
  std::vector<UrdfJoint> joints;   ///< in the file's order, except that parents come first
  std::vector<std::string> notes;  ///< "FILE:LINE: …": elements that were ignored or simplified
};

/// Parses the numbers of an attribute; returns an empty vector if any of them is invalid or not
/// finite.
std::vector<double> numbers_of(const std::string& text);

/// Largest number of links of a file that is read; the largest public URDFs have a few hundred.
inline constexpr std::size_t kMaxLinkCount = 4096;

/// Builds the joint tree of a URDF. Throws one InputError with all errors found: a link or joint
/// that is unnamed or defined twice, a joint whose links do not exist, a link with two parents, a
/// loop, more than one root, an unknown joint type, a zero axis, a lower limit above the upper one,
/// invalid numbers, more than kMaxLinkCount links, or a file that is still xacro.
UrdfTree urdf_tree(const files::XmlText& urdf);

}  // namespace morphe::robot
