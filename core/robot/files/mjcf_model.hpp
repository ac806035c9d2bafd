#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/robot/files/urdf_model.hpp"

namespace morphe::robot {

inline constexpr std::string_view kMjcfWorld = "world";  ///< the name of the world's body

/// A joint q1 = offset + ratio q2 of an MJCF that follows another; with an empty `driver`, it stays
/// at `offset`.
struct MjcfCoupling {
  std::string driver;
  double ratio = 0, offset = 0;
};

/// A hinge or slide. At the position q it turns its body by q - reference about the axis through
/// the anchor, or shifts it by that along the axis.
struct MjcfJoint {
  std::string name;
  bool slides = false;
  Vec3 anchor = Vec3::Zero(), axis = Vec3::UnitZ();  ///< in the body's frame; the axis is a unit
  double reference = 0;                              ///< [rad or m]
  std::optional<std::array<double, 2>> range;        ///< [rad or m], absent without limits
  std::optional<double> effort;                      ///< [N m or N]
  std::optional<MjcfCoupling> coupling;
  double stiffness = 0, spring_reference = 0;  ///< of a spring that acts on the joint

  /// Returns the motion of the body by this joint at a position, in the body's frame.
  Pose motion(double position) const;
};

/// A shape in its body's frame; the paths of meshes are complete.
struct MjcfGeom {
  std::string name;  ///< "" if it has no name
  UrdfShape shape;
  bool collides = true;
  bool shown = true;  ///< by MuJoCo's viewer, unless the user selects other groups
};

/// A marker in its body's frame.
struct MjcfSite {
  std::string name;
  Pose body_from_site = Pose::Identity();
};

/// A body of an MJCF. Its joints move it one after the other.
struct MjcfBody {
  std::string name;
  int parent = -1;                           ///< index of a body before this one, -1 = world
  Pose parent_from_body = Pose::Identity();  ///< with all joints at their reference
  std::vector<MjcfJoint> joints;
  std::vector<MjcfGeom> geoms;
  std::vector<MjcfSite> sites;
  std::optional<UrdfInertia> inertia;
};

/// A point that two bodies share (-1 = world), which closes a loop.
struct MjcfLoop {
  std::string name;
  int first = -1, second = -1;
  Vec3 point_in_first = Vec3::Zero(), point_in_second = Vec3::Zero();
};

/// The robot in an MJCF: the bodies below the world that have a joint or carry one.
struct MjcfModel {
  std::filesystem::path file;
  std::string name;
  std::vector<MjcfBody> bodies;  ///< parents first
  std::vector<MjcfLoop> loops;
  std::vector<std::string> notes;     ///< sentences on the parts that are left out or simplified
  std::vector<std::string> to_check;  ///< sentences on properties that the file may not intend
};

/// Reads an MJCF: bodies, hinges, slides, geoms, sites, inertias, couplings and efforts, as MuJoCo
/// 3.3 defines them. Free and ball joints are held at their reference. Throws InputError with file
/// and line of each error.
MjcfModel read_mjcf(const std::filesystem::path& file);

/// Returns the joint with that name, or nullptr if there is no such hinge or slide.
const MjcfJoint* find_joint(const MjcfModel& model, const std::string& name);

}  // namespace morphe::robot
