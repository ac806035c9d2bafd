#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/config/error_list.hpp"
#include "core/config/node.hpp"
#include "core/motion/robot_model.hpp"
#include "core/robot/dh.hpp"
#include "core/robot/files/generated_specs.hpp"
#include "core/robot/files/robot_description.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {

/// A mount point: a frame (-1 = the robot's base) and a fixed transformation relative to it.
struct MountPoint {
  int frame = -1;
  Pose frame_from_mount = Pose::Identity();
};

/// A chain of joints, the arm or a finger.
struct Chain {
  std::string name;
  bool arm = false;         ///< called `arm` by the file; finalize_robot() leaves one
  std::vector<int> frames;  ///< of its joints, base to tip
  /// The frames of joints whose axis is not along the link, like that of an anatomical joint. Of a
  /// DH table, these are the rows with d = 0. Other joints rotate about the link itself, and may
  /// have their frame at either end of it.
  std::vector<int> hinges;
  MountPoint end;  ///< behind the last link
};

/// A joint that is not driven, but fixed at a value.
struct FixedJoint {
  std::string joint;
  double position = 0;
};

/// The limits of a joint [rad or m, per s, s^2, s^3].
struct JointLimits {
  double lower, upper, velocity, acceleration, jerk;
};

/// A robot under construction while its files are read; load_robot() completes it.
struct Assembly {
  RobotModel table;                 ///< allowed pairs and centres are added last
  std::vector<JointLimits> limits;  ///< [joints] of the table, which set_limits() fills
  std::vector<Chain> chains;
  std::vector<std::filesystem::path> files;
  std::string shoulder, palm;      ///< frame names, "" if not set yet
  std::vector<std::string> notes;  ///< sentences on ignored parts of the files, changed limits …
  std::map<std::string, int> links;  ///< links of all URDFs and their frames
  std::vector<UrdfSource> urdfs;
  std::vector<std::array<int, 2>> allowed_frames;  ///< pairs whose capsules may collide
  /// For each file, the links of which some meshes were ignored.
  std::map<std::string, std::vector<std::string>> meshes;
  std::vector<int> frames_with_geometry;  ///< of links that a URDF gives a visual or a shape
  std::vector<FixedJoint> fixed_joints;
  std::vector<NaturalJoint> natural;
  std::vector<std::string> checks;  ///< of all files
  std::vector<Assumption> assumed;  ///< of all files
  config::ErrorList problems;       ///< all errors found, thrown together at the end
};

inline constexpr double kCoincidentTolerance_m = 1e-6;  ///< joints nearer than this coincide

/// The scope of one file.
struct FileScope {
  MountPoint base = {};                   ///< on which the file's robot stands
  std::string prefix = {};                ///< of all names that the file declares
  std::ptrdiff_t first_capsule = 0;       ///< of the file and its parts
  std::map<std::string, int> links = {};  ///< frames of the file's and its parts' links
};

/// Returns the items of the list below a key; empty without the key.
std::vector<config::ConfigNode> optional_items(const config::ConfigNode& node, const char* key);
/// Reads a pose, the identity without keys: `position` and one of `rpy` (Rz(yaw) Ry(pitch)
/// Rx(roll)), `quaternion` (w, x, y, z) and `matrix` (3 rows of 3; or 4 of 4, with the position).
Pose read_mount(const config::ConfigNode& node);
/// Reads the pose below the key `mount`, identity if there is no such key.
Pose read_optional_mount(const config::ConfigNode& owner);

/// Returns true if a frame or chain has that name.
bool has_frame_or_chain(const Assembly& assembly, const std::string& name);
/// Returns true if the file may mount a part on that name.
bool has_mount_point(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// Returns the frame that has this name or whose link has it, with or without the file's prefix; -1
/// if there is no such frame.
int find_frame(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// Returns the mount point with the name of a chain (its end), frame, link or "base" (that of the
/// file), in this order. Throws InputError if there is no such name.
MountPoint find_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& name);
/// Reads a mount point: the pose `mount` relative to the mount point `parent`, by default the
/// file's base.
MountPoint read_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& node);
/// Returns the index of a frame, or -1 if the name is unknown.
int frame_index(const RobotModel& table, const std::string& name);
/// Returns the actuated joint with that name, with or without the file's prefix, or -1.
int find_joint(const RobotModel& table, const FileScope& scope, const std::string& name);

/// Adds a frame and returns its index.
int append_frame(RobotModel& table, RobotModel::Frame frame);
/// Adds an actuated joint and returns its index.
int append_joint(Assembly& assembly, const std::string& name, const JointLimits& limits);
/// Copies assembly.limits to the table.
void set_limits(Assembly& assembly);

/// Adds a frame called `name`, with the file's prefix, and returns its index. Throws InputError if
/// a frame or chain has that name.
int add_frame(Assembly& assembly, const FileScope& scope, const config::ConfigNode& name,
              RobotModel::Frame frame);
/// Adds a chain of Denavit-Hartenberg rows, with its frames and joints.
void read_chain(Assembly& assembly, const FileScope& scope, DhConvention convention,
                const config::ConfigNode& node);
/// Reads the Denavit-Hartenberg convention of a chain.
DhConvention read_convention(const config::ConfigNode& node);

/// Reads `urdf: {file, srdf, shapes, velocity, acceleration, jerk, limits}` of a description:
/// joints, frames and shapes of a URDF, and data that a URDF cannot express. Every link becomes a
/// frame with the name of the joint above it, or with its own name if that joint is fixed.
void read_urdf(Assembly& assembly, FileScope& scope, const config::ConfigNode& node);
/// Reads `{name, first, last}`: a chain of the frames of a URDF from one joint or link to another.
void read_urdf_chain(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);

/// Adds the chain, tip and palm of a generated arm at `base`. The names must not be in use yet.
void add_generated_arm(Assembly& assembly, const MountPoint& base, const ArmSpec& shape);
/// Adds the chains, tips and palm of a generated hand at `base`. The names must not be in use yet.
void add_generated_hand(Assembly& assembly, const MountPoint& base, const HandSpec& shape);
/// Reads {arm: {…}} or {hand: {…}} of a description. Throws InputError if values are invalid or
/// names in use.
void read_generated(Assembly& assembly, const MountPoint& base, const config::ConfigNode& node);

/// Removes the wrist tip of the arm on which a part is mounted: the part's own tips replace it.
void remove_parent_wrist_tip(Assembly& assembly, const MountPoint& mount);

/// Adds a file's capsules, allowed pairs and marks of capsules that may touch the target.
void read_collision(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);
/// Allows collisions between the capsules of two frames.
void allow_frames(RobotModel& table, int one, int other);
/// Allows collisions between capsules of one rigid body, or of two bodies that one joint connects,
/// and removes repeated pairs.
void allow_neighbours(RobotModel& table);

/// Adds joint centres (metric A) for every chain for which the files give no centre. Those of the
/// arm are its hinges at distinct places beyond the shoulder; if it carries no other chain, the
/// last of several is omitted, because it is the end effector's. That of a finger is the first
/// hinge away from its base.
void derive_centres(Assembly& assembly);

/// Tightens every joint's limits by those of the frames coupled to it, and its range such that the
/// braking curve allows a twentieth of the velocity limit at both ends. Notes what is reduced. Adds
/// a problem if no position remains.
void tighten_limits(Assembly& assembly);

/// Fixes `fixed_joints`. If there are tips, also fixes all joints that move no tip, as near to 0 as
/// their limits allow, and notes them.
void fix_joints(Assembly& assembly);

/// Returns the names of the links that a URDF gives a visual or a shape, and of the bodies with a
/// joint or tip more than 1 cm from their origin, that have no capsule.
std::vector<std::string> unchecked_links(const Assembly& assembly);

/// Completes the table, which must have a palm or an arm, with limits, shoulder, palm, centres,
/// allowed pairs and unchecked links. Errors are added to assembly.problems.
void finalize_robot(Assembly& assembly);

}  // namespace morphe::robot
