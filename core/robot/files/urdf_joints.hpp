#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/files/xml_text.hpp"

namespace morphe::robot {

/// The kind of a URDF's joint; planar and floating ones, which cannot be driven, count as fixed.
enum class JointKind { fixed, revolute, continuous, prismatic };

/// The widest limits in a URDF that are believed: beyond two turns they are in degrees or wrong,
/// and beyond 20 m in millimetres. Chosen by hand: UR and xArm have one turn, some wrists 1.3
/// turns; the smallest limit of an arm in degrees that matters is about 30.
inline constexpr double kMaxBelievedLimit_rad = 12.566370614359172, kMaxBelievedLimit_m = 20;
/// Limits of a revolute joint from which on programs mean "no limit" [rad]; 720 degrees are below.
inline constexpr double kEndless_rad = 1000;

/// A joint of a URDF and its element in the file.
struct UrdfJoint {
  std::string name, parent, child;
  JointKind kind = JointKind::fixed;
  /// As written. Absent are a velocity that is not above 0, and lower and upper if the file gives
  /// neither, or if the joint is continuous. Equal limits lock the joint, unless it is coupled:
  /// then they contradict the coupling, and count as absent, too.
  std::optional<double> lower, upper, velocity;
  const files::XmlElement* element = nullptr;  ///< valid as long as the file's text
};

/// The joints of a URDF, in topological order.
struct UrdfTree {
  std::string root;                ///< the link without a parent
  std::vector<UrdfJoint> joints;   ///< in the file's order, except that parents come first
  std::vector<std::string> notes;  ///< "FILE:LINE: …": elements that were ignored or simplified
};

/// Returns the joint with that name, or nullptr if there is no such joint.
const UrdfJoint* find_joint(const UrdfTree& tree, const std::string& name);

/// Parses the numbers of an attribute; returns an empty list if one of them is invalid or infinite.
std::vector<double> numbers_of(const std::string& text);

/// Maximum number of links of a URDF; the largest public URDFs have a few hundred.
inline constexpr std::size_t kMaxLinkCount = 4096;

/// Builds the joint tree of a URDF. Throws InputError, with the errors of the first of these steps
/// that fails: the file is still xacro; it has more than kMaxLinkCount links; a link or joint is
/// unnamed or defined twice, or a number is invalid; a joint has an unknown type or link, a child
/// that is another joint's, a zero axis, or a lower limit above the upper one; there is no joint;
/// there is more than one root; there is a loop.
UrdfTree urdf_tree(const files::XmlText& urdf);

}  // namespace morphe::robot
