#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"
#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {

/// A shape of a link as defined in the URDF.
struct UrdfShape {
  std::string link;
  Shape kind = Shape::mesh;
  Vec3 size = Vec3::Ones();  ///< sphere r; box x, y, z; cylinder and capsule r, length; mesh scale
  std::string mesh;          ///< path of the mesh as written in the file
  Pose link_from_shape = Pose::Identity();
  bool visual = false;  ///< true for visual, false for collision geometry
};

/// The inertial element of a link.
struct UrdfInertia {
  double mass = 0;  ///< [kg]
  Pose link_from_inertia = Pose::Identity();
  /// About the centre of mass, in the axes of the inertial element [kg m²].
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// A URDF by itself. Missing limits are assumed. Joints that the file locks are fixed; joints that
/// move no fingertip are not.
struct UrdfModel {
  std::filesystem::path file;
  std::string name;
  UrdfTree tree;
  RobotModel table;                  ///< without tips, shoulder, palm and capsules
  std::map<std::string, int> links;  ///< frames by the names of links
  std::vector<UrdfShape> shapes;
  std::map<std::string, UrdfInertia> inertias;
  std::vector<std::string> notes;

  /// Returns the joint with that name, or nullptr if there is no such joint.
  const UrdfJoint* joint(const std::string& called) const { return find_joint(tree, called); }
  /// Returns the name of the link of each frame.
  std::vector<std::string> link_of_frame() const;
};

/// The limits [rad or m, per s, s^2, s^3] of all joints for which the URDF gives no limits.
struct AssumedLimits {
  double position = 3.14159265358979;  ///< in both directions [rad or m]
  double velocity = 1, acceleration = 1, jerk = 1;
};

/// Lower and upper limits of position that replace those of a URDF, by the names of its joints.
using GivenLimits = std::map<std::string, std::array<double, 2>>;

/// Reads a URDF; throws InputError as load_robot() does, and if `given` names an unknown joint.
UrdfModel load_urdf_model(const std::filesystem::path& file, const GivenLimits& given = {},
                          const AssumedLimits& assumed = {});

}  // namespace morphe::robot
