#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/motion/scene.hpp"
#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {

/// A shape of a link as the URDF has it.
struct UrdfShape {
  std::string link;
  Shape kind = Shape::mesh;
  Vec3 size = Vec3::Ones();  ///< sphere r, -, -; box x, y, z; cylinder r, length, -; mesh scale
  std::string mesh;          ///< as it is named there
  Pose link_from_shape = Pose::Identity();
  bool visual = false;  ///< of the picture, not of collision
};

/// What an inertial element says of a link.
struct UrdfInertia {
  double mass = 0;
  Pose link_from_inertia = Pose::Identity();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass [kg m²]
};

/// A URDF by itself, before anybody said what of it is a finger: every joint drives, none is held.
/// Limits that are missing are those of `assumed`.
struct UrdfModel {
  std::filesystem::path file;
  std::string name;
  UrdfTree tree;
  RobotTable table;                  ///< without tips, shoulder, palm and capsules
  std::map<std::string, int> links;  ///< each is a frame
  std::vector<UrdfShape> shapes;
  std::map<std::string, UrdfInertia> inertias;
  std::vector<std::string> notes;

  const UrdfJoint* joint(const std::string& called) const;  ///< nullptr: none
  /// The link that a frame is, by its index.
  std::vector<std::string> link_of_frame() const;
};

/// For all joints whose limits are missing.
struct AssumedLimits {
  double position = 3.14159265358979;  ///< both ways [rad or m]
  double velocity = 1, acceleration = 1, jerk = 1;
};

/// Reads a URDF; throws InputError as load_robot() does.
UrdfModel load_urdf_model(const std::filesystem::path& file, const AssumedLimits& assumed = {});

}  // namespace morphe::robot
