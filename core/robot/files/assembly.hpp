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
#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
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
  bool arm = false;         ///< true if the file calls it `arm`
  std::vector<int> frames;  ///< of its joints, base to tip
  /// The joints whose axis is not along the link, as an anatomical joint: DH rows with d = 0. The
  /// frame of a row with d != 0 rotates about the link itself and lies, by convention, at either
  /// end of it.
  std::vector<int> hinges;
  MountPoint end;  ///< behind the last link
};

/// A joint that is not driven, but fixed at a value.
struct FixedJoint {
  std::string joint;
  double position = 0;
};

/// A robot under construction while its files are read; load_robot() completes it.
struct Assembly {
  /// The model; its limits are copied from the lists below, allowed pairs and centres are added
  /// last.
  RobotModel table;
  std::vector<double> lower, upper, velocity, acceleration, jerk;
  std::vector<Chain> chains;
  std::vector<std::filesystem::path> files;
  std::string shoulder, palm;        ///< frame names, "" if not set yet
  std::vector<std::string> notes;    ///< parts of the files that were ignored
  std::map<std::string, int> links;  ///< links of all URDFs and their frames
  std::vector<UrdfSource> urdfs;
  /// Pairs of frames whose capsules are allowed to collide.
  std::vector<std::array<int, 2>> allowed_frames;
  /// For each file, the links of which some meshes were ignored.
  std::map<std::string, std::vector<std::string>> meshes;
  /// Frames of links whose shapes were ignored.
  std::vector<int> frames_with_geometry;
  std::vector<FixedJoint> fixed_joints;
  std::vector<NaturalJoint> natural;
  config::ErrorList problems;  ///< all errors found, thrown together at the end
};

/// Hinges closer together than this count as coincident [m].
inline constexpr double kCoincidentTolerance_m = 1e-6;

/// The scope of one file: its own base, its name prefix, and the index of its first capsule
/// (capsules of its parts included).
struct FileScope {
  MountPoint base = {};
  std::string prefix = {};  ///< prefix of all names that the file declares
  std::size_t first_capsule = 0;
  /// Links of its URDF and those of its parts, as alternative names of frames.
  std::map<std::string, int> links = {};
};

/// Reads a pose: position (default zero) and one of rpy (fixed axes: Rz(yaw) Ry(pitch) Rx(roll)),
/// quaternion (w, x, y, z) or matrix (3 rows of 3, or 4 of 4 that contain the position too);
/// default identity.
Pose read_mount(const config::ConfigNode& node);
/// Reads the pose below the key `mount`, identity if there is no such key.
Pose read_optional_mount(const config::ConfigNode& owner);

/// Returns true if a frame or chain has that name.
bool has_frame_or_chain(const Assembly& assembly, const std::string& name);
/// Returns true if the file may mount a part on that name.
bool has_mount_point(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// Returns the frame with the name of a frame or a link, with or without the file's prefix, or -1
/// if there is no such frame.
int find_frame(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// Returns the mount point with the name of a frame or link, the end of a chain, or the base of the
/// file ("base"); throws InputError if there is no such name.
MountPoint find_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& name);
/// Reads a mount point: the parent's mount point * mount; the parent is the file's base if `node`
/// has no key `parent`.
MountPoint read_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& node);
/// Returns the index of a frame, or -1 if the name is unknown.
int frame_index(const RobotModel& table, const std::string& name);

/// Adds a frame, its name prefixed with the file's prefix, and returns its index; throws InputError
/// if the name is already in use.
int add_frame(Assembly& assembly, const FileScope& scope, const config::ConfigNode& name,
              RobotModel::Frame frame);
/// Adds the frames and joints of a chain.
void read_chain(Assembly& assembly, const FileScope& scope, DhConvention convention,
                const config::ConfigNode& node);
/// Reads the Denavit-Hartenberg convention of a chain.
DhConvention read_convention(const config::ConfigNode& node);

/// Reads `urdf: {file, srdf, shapes, velocity, acceleration, jerk, limits}` of a description: the
/// joints, frames and shapes of a URDF, with the data that a URDF cannot express. Every link
/// becomes a frame, with the name of its joint, or its own name if it is fixed.
void read_urdf(Assembly& assembly, FileScope& scope, const config::ConfigNode& node);
/// Reads `{name, first, last}`, which declares the joints of a URDF between two joints as a chain.
void read_urdf_chain(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);

/// Adds the chain, tip and palm of a generated arm at `base`. The names must not be in use yet.
void add_generated_arm(Assembly& assembly, const MountPoint& base, const ArmSpec& shape);
/// Adds the chains, tips and palm of a generated hand at `base`. The names must not be in use yet.
void add_generated_hand(Assembly& assembly, const MountPoint& base, const HandSpec& shape);
/// Reads {arm: {…}} or {hand: {…}} of a description; throws InputError as for any other part of it.
void read_generated(Assembly& assembly, const MountPoint& base, const config::ConfigNode& node);

/// Removes the wrist tip of the parent on which a part is mounted, because the part's own tips
/// replace it.
void remove_parent_wrist_tip(Assembly& assembly, const MountPoint& place);

/// Adds a file's capsules. Names may end in `*` in allowed_collision_pairs and may_touch_target.
void read_collision(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);
/// Allows collisions between the capsules of two frames, among those of the file.
void allow_frames(RobotModel& table, std::size_t first_capsule, int one, int other);
/// Allows collisions between capsules of one rigid body, or of two bodies that one joint connects.
void allow_neighbours(RobotModel& table);

/// Adds centres of metric A for every chain for which the files give no centres. For `arm` these
/// are the distinct hinges beyond the shoulder, without the last one if the arm carries no hand (it
/// is then the end effector's), unless it is the only one; for a finger, the first hinge away from
/// its base.
void derive_centres(Assembly& assembly);

/// Tightens every joint's limits as required by the limits of frames coupled to it, and such that
/// its braking curve allows at least a twentieth of its velocity limit. Notes the reductions above
/// 1e-3, and adds a problem if no position remains.
void tighten_limits(Assembly& assembly);

/// Fixes the joints of `hold`, and all joints that move no tip (at the position nearest to zero,
/// with a note).
void fix_joints(Assembly& assembly);

/// Returns the links and bodies without a capsule that have a shape or extend from one joint to the
/// next.
std::vector<std::string> unchecked_links(const Assembly& assembly);

/// Completes the model with limits, shoulder, palm, centres and allowed neighbours. It must have a
/// palm or an arm. Errors are added to assembly.problems.
void finalize_robot(Assembly& assembly);

}  // namespace morphe::robot
