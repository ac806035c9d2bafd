// Where the shipped robots' joints are, against products of matrices of the numbers in their URDFs,
// which are read here line by line and not by the reader.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/generated_products.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

struct UrdfJoint {
  std::string type, parent, child, master;
  Vec3 xyz = Vec3::Zero(), rpy = Vec3::Zero(), axis = Vec3::UnitX();
  double multiplier = 1, offset = 0;
};
using UrdfJoints = std::map<std::string, UrdfJoint>;

std::string attribute(const std::string& line, const std::string& name) {
  std::smatch found;
  return std::regex_search(line, found, std::regex(" " + name + "=\"([^\"]*)\"")) ? found[1].str()
                                                                                  : "";
}

Vec3 three(const std::string& text) {
  Vec3 v;
  std::istringstream(text) >> v.x() >> v.y() >> v.z();
  return v;
}

UrdfJoints read_joints(const std::filesystem::path& file) {
  UrdfJoints joints;
  UrdfJoint* last = nullptr;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto is = [&](const char* element) { return line.find(element) != std::string::npos; };
    if (is("<joint ")) {
      last = &joints[attribute(line, "name")];
      last->type = attribute(line, "type");
    } else if (is("<parent ")) {
      last->parent = attribute(line, "link");
    } else if (is("<child ")) {
      last->child = attribute(line, "link");
    } else if (is("<origin ")) {
      last->xyz = three(attribute(line, "xyz"));
      last->rpy = three(attribute(line, "rpy"));
    } else if (is("<axis ")) {
      last->axis = three(attribute(line, "xyz")).normalized();
    } else if (is("<mimic ")) {
      last->master = attribute(line, "joint");
      if (is("multiplier=")) last->multiplier = std::stod(attribute(line, "multiplier"));
      if (is("offset=")) last->offset = std::stod(attribute(line, "offset"));
    }
  }
  return joints;
}

/// Rodrigues' formula, or a slide.
Mat4 moved(const UrdfJoint& joint, double value) {
  Mat4 m = Mat4::Identity();
  const Vec3 a = joint.axis;
  if (joint.type == "prismatic") {
    m.topRightCorner<3, 1>() = value * a;
  } else if (joint.type != "fixed") {
    Eigen::Matrix3d cross;
    cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    m.topLeftCorner<3, 3>() += std::sin(value) * cross + (1 - std::cos(value)) * cross * cross;
  }
  return m;
}

class ShippedUrdf : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel robot = shipped_robot(GetParam());
  const UrdfJoints joints =
      read_joints(robot_file("any").parent_path() / "urdf" / (GetParam() + ".urdf"));

  double value(const std::string& name, const JointVector& q) const {
    const auto driven = std::ranges::find(robot.joint_names, name);
    if (driven != robot.joint_names.end()) return q[driven - robot.joint_names.begin()];
    const UrdfJoint& joint = joints.at(name);
    return joint.master.empty() ? 0 : joint.multiplier * value(joint.master, q) + joint.offset;
  }
  Mat4 root_from(const std::string& link, const JointVector& q) const {
    for (const auto& [name, joint] : joints) {
      if (joint.child != link) continue;
      return root_from(joint.parent, q) * shift(joint.xyz.x(), joint.xyz.y(), joint.xyz.z()) *
             rotation(2, joint.rpy.z()) * rotation(1, joint.rpy.y()) * rotation(0, joint.rpy.x()) *
             moved(joint, value(name, q));
    }
    return Mat4::Identity();
  }
};

TEST_P(ShippedUrdf, EveryJointIsWhereItsNumbersPutIt) {
  ASSERT_FALSE(joints.empty());
  std::mt19937 random(2);
  std::vector<Pose> frames;
  double worst = 0;
  std::size_t compared = 0;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, frames);
    for (const auto& [name, joint] : joints) {
      const std::size_t frame = frame_named(robot, name);
      if (frame == robot.frames.size()) continue;  // a fixed one: its link is a frame
      worst = std::max(worst,
                       (frames[frame].matrix() - root_from(joint.child, q)).cwiseAbs().maxCoeff());
      ++compared;
    }
  }
  EXPECT_GE(compared, 20 * robot.joints());
  EXPECT_LT(worst, 1e-9);
}

std::vector<std::string> of_urdfs() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_robots()) {
    if (std::filesystem::exists(robot_file("any").parent_path() / "urdf" / (name + ".urdf"))) {
      names.push_back(name);
    }
  }
  return names;
}
INSTANTIATE_TEST_SUITE_P(Robots, ShippedUrdf, testing::ValuesIn(of_urdfs()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace morphe::robot
