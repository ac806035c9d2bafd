// URDFs of hands and grippers made of boxes, whose answers follow from the numbers in them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/setup.hpp"
#include "tests/core/robot/files/written_urdf.hpp"

namespace morphe::setup {

/// A link with the joint above it, and the box that is its shape.
struct Part {
  std::string link, parent, origin, axis = "0 0 1", limits, more = {};
  std::string type = "revolute";
  std::string box_at = {}, box = {};  ///< "" for a link without a shape
};

inline std::string box_shape(const std::string& at, const std::string& size) {
  return size.empty() ? ""
                      : fmt::format(
                            "<collision><origin xyz=\"{}\"/><geometry><box size=\"{}\"/>"
                            "</geometry></collision>",
                            at, size);
}

inline std::string limit(double lower, double upper, double velocity = 2) {
  return fmt::format("<limit lower=\"{}\" upper=\"{}\" velocity=\"{}\" effort=\"1\"/>", lower,
                     upper, velocity);
}

/// Joints are called as their links with "_j" behind.
inline std::string urdf_of_parts(const std::string& root, const std::vector<Part>& parts,
                                 const std::string& root_shape = "") {
  std::string text =
      fmt::format("<robot name=\"made\"><link name=\"{}\">{}</link>\n", root, root_shape);
  for (const Part& part : parts)
    text += fmt::format(
        "<link name=\"{0}\">{1}</link><joint name=\"{0}_j\" type=\"{2}\"><parent link=\"{3}\"/>"
        "<child link=\"{0}\"/><origin xyz=\"{4}\"/><axis xyz=\"{5}\"/>{6}{7}</joint>\n",
        part.link, box_shape(part.box_at, part.box), part.type, part.parent, part.origin, part.axis,
        part.limits, part.more);
  return text + "</robot>\n";
}

/// An arm of five or six joints that ends at the link l5 or l6.
inline std::vector<Part> hobby_arm(int joints = 5) {
  const std::vector<const char*> axes = {"0 0 1", "0 1 0", "0 1 0", "0 1 0", "0 0 1", "0 1 0"};
  std::vector<Part> parts;
  for (int k = 1; k <= joints; ++k)
    parts.push_back({fmt::format("l{}", k), k == 1 ? "base" : fmt::format("l{}", k - 1),
                     fmt::format("0 0 {}", k < 3 ? 0.06 : 0.12),
                     axes[static_cast<std::size_t>(k - 1)], limit(-2.5, 2.5)});
  return parts;
}

struct MadeHand {
  SetupResult result;
  robot::RobotDescription description;

  const RobotModel& table() const { return description.table; }
  /// Returns the tips at joint positions, by the index of their finger.
  Pose tip(int finger, const JointVector& q) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(table(), q, poses);
    for (std::ptrdiff_t i = 0; i < std::ssize(table().tips); ++i)
      if (table().tips[static_cast<std::size_t>(i)].finger == finger)
        return robot::tip_pose(table(), poses, i);
    ADD_FAILURE() << "no tip of finger " << finger;
    return Pose::Identity();
  }
  /// Returns the pad of a finger: its tip is 10 mm below it.
  Vec3 pad(int finger, const JointVector& q) const { return tip(finger, q) * Vec3(0.01, 0, 0); }
  /// Returns the name of the frame that carries the tip of a finger, "" without such a tip.
  std::string carrier(int finger) const {
    for (const RobotModel::Tip& tip : table().tips)
      if (tip.finger == finger) return table().frames[static_cast<std::size_t>(tip.frame)].name;
    return "";
  }
  /// Returns all joints at zero, or as near as possible, and one at a position.
  JointVector with(const std::string& joint, double position) const {
    JointVector q =
        JointVector::Zero(table().lower.size()).cwiseMax(table().lower).cwiseMin(table().upper);
    const auto found = std::ranges::find(table().joint_names, joint);
    EXPECT_NE(found, table().joint_names.end()) << joint;
    q[found - table().joint_names.begin()] = position;
    return q;
  }
};

inline MadeHand set_up_parts(const std::string& urdf, SetupRequest request = {}) {
  request.urdf = robot::write_text("made.urdf", urdf);
  request.out = robot::robot_folder() / "made.yaml";
  request.budget = {1, 1, 1, 1, 1};
  MadeHand made{make_description(request, std::nullopt), {}};
  made.description = robot::parse_robot(made.result.text, request.out);
  return made;
}

}  // namespace morphe::setup
