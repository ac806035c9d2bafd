#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/config/node.hpp"
#include "core/config/problems.hpp"
#include "core/motion/robot_table.hpp"
#include "core/robot/dh.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {

/// A robot while its files are read; load_robot() puts it together.

/// Where something hangs: a frame (-1 = the robot's base) and the fixed rest of the way.
struct Anchor {
  int frame = -1;
  Pose frame_from_anchor = Pose::Identity();
};

struct Chain {
  std::string name;
  bool arm = false;         ///< called `arm` in its file
  std::vector<int> frames;  ///< of its joints, base to tip
  /// Those that turn across a link, where a person would see a joint: rows with d = 0. The frame of
  /// a row with d != 0 turns about the link itself and lies, by convention, at either of its ends.
  std::vector<int> hinges;
  Anchor end;  ///< after the last link
};

/// A joint that is not driven but stands still at a value.
struct HeldJoint {
  std::string joint;
  double at = 0;
};

struct Assembly {
  RobotTable table;  ///< limits are filled from the lists below, allowed pairs and centres at last
  std::vector<double> lower, upper, velocity, acceleration, jerk;
  std::vector<Chain> chains;
  std::vector<std::filesystem::path> files;
  std::string shoulder, palm;        ///< frame names, "" = not named yet
  std::vector<std::string> notes;    ///< what was left out
  std::map<std::string, int> links;  ///< of all URDFs: the frame that each is
  std::vector<UrdfSource> urdfs;
  std::vector<std::array<int, 2>> allowed_frames;  ///< no capsule of one collides with the other's
  std::map<std::string, std::vector<std::string>> meshes;  ///< of a file: links with some left out
  std::vector<int> shaped;  ///< frames of links whose shapes were left out
  std::vector<HeldJoint> held;
  std::vector<NaturalJoint> natural;
  config::Problems problems;  ///< all that is wrong, told at the end
};

/// Hinges nearer than this stand in one place [m].
inline constexpr double kSamePoint_m = 1e-6;

/// One file's view: its own base, and where its frames and capsules begin (those of its parts
/// included).
struct FileScope {
  Anchor base = {};
  std::string prefix = {};  ///< of all names that the file gives
  std::size_t first_capsule = 0;
  std::map<std::string, int> links = {};  ///< of its URDF and its parts': other names of frames
};

/// position (default zero) and one of rpy (fixed axes: Rz(yaw) Ry(pitch) Rx(roll)), quaternion
/// (w, x, y, z) or matrix (3 rows of 3, or 4 of 4 that hold the position too); default identity.
Pose read_mount(const config::ConfigNode& node);
/// The same below the key `mount`, identity if there is none.
Pose read_mount_of(const config::ConfigNode& owner);

/// True if a frame or chain has that name.
bool has_anchor(const Assembly& assembly, const std::string& name);
/// True if the file may hang something on that name.
bool is_known(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// The frame of that name, or of that link, with the file's prefix or without; -1 if there is none.
int frame_called(const Assembly& assembly, const FileScope& scope, const std::string& name);
/// A frame or link, the end of a chain, or the base of the file ("base"); InputError if none of
/// them.
Anchor anchor_named(const Assembly& assembly, const FileScope& scope,
                    const config::ConfigNode& name);
/// parent's place * mount; the file's base if `node` has no key `parent`.
Anchor read_hanging(const Assembly& assembly, const FileScope& scope,
                    const config::ConfigNode& node);
int frame_index(const RobotTable& table, const std::string& name);  ///< -1 if unknown

/// Adds a frame, its name with the file's prefix; InputError if that is taken. Returns its index.
int add_frame(Assembly& assembly, const FileScope& scope, const config::ConfigNode& name,
              RobotTable::Frame frame);
/// Adds a chain's frames and joints.
void read_chain(Assembly& assembly, const FileScope& scope, DhConvention convention,
                const config::ConfigNode& node);
DhConvention read_convention(const config::ConfigNode& node);

/// `urdf: {file, srdf, shapes, velocity, acceleration, jerk, limits}` of a description: the joints,
/// frames and shapes of a URDF, with what a URDF cannot say. Every link is a frame: a joint's, by
/// the joint's name, or a fixed one by its own.
void read_urdf(Assembly& assembly, FileScope& scope, const config::ConfigNode& node);
/// `{name, first, last}`: names the joints of a URDF from one to another a chain.
void read_urdf_chain(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);

/// Adds a generated robot's chains, tips and palm at `base`, which names must not be taken.
void add_generated_arm(Assembly& assembly, const Anchor& base, const ArmShape& shape);
void add_generated_hand(Assembly& assembly, const Anchor& base, const HandShape& shape);
/// {arm: {…}} or {hand: {…}} of a description; InputError as for any other part of it.
void read_generated(Assembly& assembly, const Anchor& base, const config::ConfigNode& node);

/// What carries a part at `place` ends in that part's tips, no longer in its own wrist.
void drop_carriers_wrist(Assembly& assembly, const Anchor& place);

/// Adds a file's capsules; names may end in `*` in allowed_pairs and may_touch_target.
void read_collision(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node);
/// No capsule of the one frame collides with one of the other, among those of the file.
void allow_frames(RobotTable& table, std::size_t first_capsule, int one, int other);
/// Capsules of one rigid body, or of two that one joint connects.
void allow_neighbours(RobotTable& table);

/// Centres of metric A for every chain that the files gave none: for `arm` the distinct hinges
/// beyond the shoulder, without the last one if the arm carries nothing (there it is the
/// end-effector's), unless it is the only one; for a finger the first hinge away from its base.
void derive_centres(Assembly& assembly);

/// Draws every joint's limits in as far as what is coupled to it needs, and as its braking curve
/// leaves it a twentieth of its velocity; notes what that takes away (above 1e-3). A problem if
/// nothing is left.
void draw_in_limits(Assembly& assembly);

/// Fixes the joints to be held, and all that move no tip (where they are nearest to zero; noted).
void hold_joints(Assembly& assembly);

/// The links and bodies without a capsule that have a shape or reach from one joint to the next.
std::vector<std::string> unchecked_links(const Assembly& assembly);

/// The table, with limits, shoulder, palm, centres and allowed neighbours. There must be a palm or
/// an arm. What is wrong comes to assembly.problems.
void finish(Assembly& assembly);

}  // namespace morphe::robot
