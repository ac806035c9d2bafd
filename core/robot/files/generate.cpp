#include "core/robot/files/generate.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "core/motion/human_motion.hpp"
#include "core/robot/files/assembly.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::robot {
namespace {

int capsule_count(const Assembly& assembly) {
  return static_cast<int>(std::ssize(assembly.table.capsules));
}

/// Returns a frame whose z axis is the joint axis (± x, y or z), as in DH joints.
Pose frame_about(const Vec3& axis) {
  Eigen::Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = Vec3::Unit((along + 1) % 3);
  pose.linear().col(1) = axis.cross(pose.linear().col(0));
  pose.linear().col(2) = axis;
  return pose;
}

/// Adds a driven revolute joint about `axis` (± x, y or z of the mount point); returns the mount
/// point that it moves, which is the same at zero.
MountPoint add_revolute_joint(Assembly& assembly, Chain& chain, const std::string& name,
                              const MountPoint& mount, const Vec3& axis,
                              const JointLimits& limits) {
  RobotModel::Frame frame;
  frame.name = name;
  frame.parent = mount.frame;
  const Pose about = frame_about(axis);
  frame.transform = mount.frame_from_mount * about;
  frame.joint = append_joint(assembly, name, limits);
  chain.frames.push_back(append_frame(assembly.table, std::move(frame)));
  return {chain.frames.back(), about.inverse()};
}

MountPoint translated(MountPoint mount, double x, double y, double z) {
  mount.frame_from_mount = mount.frame_from_mount * Eigen::Translation3d(x, y, z);
  return mount;
}

MountPoint rotated(MountPoint mount, double angle, const Vec3& axis) {
  mount.frame_from_mount = mount.frame_from_mount * Eigen::AngleAxisd(angle, axis);
  return mount;
}

int add_fixed(Assembly& assembly, const std::string& name, const MountPoint& mount) {
  return append_frame(assembly.table, {name, mount.frame, mount.frame_from_mount});
}

void add_tip(Assembly& assembly, const std::string& name, const MountPoint& mount, int finger,
             double curve_share) {
  assembly.table.tips.push_back({name, mount.frame, mount.frame_from_mount, finger, curve_share});
}

/// Adds a capsule along z of a mount point and returns its index; -1 if the radius is not positive.
int add_capsule(Assembly& assembly, const std::string& name, const MountPoint& mount, double length,
                double radius, bool may_touch_target) {
  if (!(radius > 0)) return -1;
  const Vec3 from = mount.frame_from_mount * Vec3::Zero().eval();
  const Vec3 to = mount.frame_from_mount * Vec3(0, 0, length);
  assembly.table.capsules.push_back({name, mount.frame, from, to, radius, may_touch_target});
  return capsule_count(assembly) - 1;
}

/// Allows a collision of capsules that meet although more than one joint connects them; -1 stands
/// for a capsule that was not added.
void allow_capsule_pair(Assembly& assembly, int one, int other) {
  if (one < 0 || other < 0) return;
  assembly.table.allowed_collision_pairs.push_back({std::min(one, other), std::max(one, other)});
}

/// Interpolates the finger at the parameter `share` from index (0) to little (1) between the two
/// human fingers next to it.
FingerProportions interpolate_finger(double share) {
  const int before = static_cast<int>(std::min(2.0, std::floor(3 * share)));
  const double t = 3 * share - before;
  const FingerProportions& a = kFingerProportions[before];
  const FingerProportions& b = kFingerProportions[before + 1];
  const auto mix = [t](double x, double y) { return t == 1 ? y : x + t * (y - x); };
  FingerProportions f{};
  for (const auto member :
       {&FingerProportions::across, &FingerProportions::along, &FingerProportions::proximal,
        &FingerProportions::middle, &FingerProportions::distal, &FingerProportions::splay}) {
    f.*member = mix(a.*member, b.*member);
  }
  for (int k = 0; k < std::ssize(f.lower); ++k) {
    f.lower[k] = mix(a.lower[k], b.lower[k]);
    f.upper[k] = mix(a.upper[k], b.upper[k]);
  }
  return f;
}

const Vec3 kFlexionAxis = Vec3::UnitY();  ///< flexes towards x, out of the palm
const Vec3 kAbductionAxis = -Vec3::UnitX();

template <class Spec>
JointLimits joint_limits(const Spec& shape, double lower, double upper) {
  return {lower, upper, shape.velocity, shape.acceleration, shape.jerk};
}

void add_thumb(Assembly& assembly, const HandSpec& shape, const MountPoint& palm) {
  const ThumbProportions& t = kThumbProportions;
  const double radius = shape.radius, length = shape.length;
  Chain chain{"thumb", false, {}, {}, {}};
  const auto joint = [&](const char* name, const MountPoint& mount, const Vec3& axis, int k) {
    return add_revolute_joint(assembly, chain, name, mount, axis,
                              joint_limits(shape, t.lower[k], t.upper[k]));
  };
  MountPoint mount = translated(palm, 0, t.across * shape.breadth, t.along * length);
  mount = joint("thumb_rotation", mount, -Vec3::UnitZ(), 0);
  mount = joint("thumb_abduction", rotated(mount, t.splay, kAbductionAxis), kAbductionAxis, 1);
  const int metacarpal =
      add_capsule(assembly, "thumb_metacarpal", mount, t.metacarpal * length, radius, true);
  for (int k = 1; k < shape.fingers; ++k) allow_capsule_pair(assembly, metacarpal - k, metacarpal);
  // From here on x points out of the thumb's pad, which at zero is across the palm.
  mount = rotated(translated(mount, 0, 0, t.metacarpal * length), radians(-90), Vec3::UnitZ());
  mount = joint("thumb_mcp", mount, kFlexionAxis, 2);
  chain.hinges = {chain.frames.front(), mount.frame};
  add_capsule(assembly, "thumb_proximal", mount, t.proximal * length, radius, true);
  mount = joint("thumb_ip", translated(mount, 0, 0, t.proximal * length), kFlexionAxis, 3);
  add_capsule(assembly, "thumb_distal", mount, t.distal * length, radius, true);
  chain.end = translated(mount, 0, 0, t.distal * length);
  add_tip(assembly, "thumb_tip", chain.end, 0, kUnknown);
  assembly.chains.push_back(std::move(chain));
}

std::string finger_name(const HandSpec& shape, int number) {
  return shape.fingers == kFingerCount ? kFingerNames[number] : fmt::format("finger{}", number);
}

/// Returns the parameter of a finger, 0 for finger 1 to 1 for the last.
double share_of(const HandSpec& shape, int number) { return (number - 1.0) / (shape.fingers - 2); }

/// Adds the capsule of the metacarpal, which begins at the palm's end at the wrist and ends at the
/// finger's base.
void add_metacarpal(Assembly& assembly, const HandSpec& shape, const MountPoint& palm, int number) {
  const FingerProportions f = interpolate_finger(share_of(shape, number));
  const double along = f.along * shape.length, begin = std::min(shape.radius, along);
  add_capsule(assembly, finger_name(shape, number) + "_metacarpal",
              translated(palm, 0, f.across * shape.breadth, begin), along - begin, shape.radius,
              true);
}

/// Adds a finger. The capsules of the metacarpals begin at the index `first_metacarpal`.
void add_finger(Assembly& assembly, const HandSpec& shape, const MountPoint& palm,
                int first_metacarpal, int number) {
  const double share = share_of(shape, number);
  const FingerProportions f = interpolate_finger(share);
  const std::string name = finger_name(shape, number);
  Chain chain{name, false, {}, {}, {}};
  const auto joint = [&](const char* ending, const MountPoint& mount, const Vec3& axis, int k) {
    return add_revolute_joint(assembly, chain, name + ending, mount, axis,
                              joint_limits(shape, f.lower[k], f.upper[k]));
  };
  const double length = shape.length;
  MountPoint mount = translated(palm, 0, f.across * shape.breadth, f.along * length);
  mount = joint("_abduction", rotated(mount, -f.splay, kAbductionAxis), kAbductionAxis, 0);
  mount = joint("_mcp", mount, kFlexionAxis, 1);
  const auto phalanx = [&](const char* ending, double relative_length) {
    return add_capsule(assembly, name + ending, mount, relative_length * length, shape.radius,
                       true);
  };
  const int proximal = phalanx("_proximal", f.proximal);
  for (int k = 0; k + 1 < shape.fingers; ++k)
    allow_capsule_pair(assembly, first_metacarpal + k, proximal);
  mount = joint("_pip", translated(mount, 0, 0, f.proximal * length), kFlexionAxis, 2);
  chain.hinges = {chain.frames.front(), mount.frame};
  phalanx("_middle", f.middle);
  mount = joint("_dip", translated(mount, 0, 0, f.middle * length), kFlexionAxis, 3);
  phalanx("_distal", f.distal);
  chain.end = translated(mount, 0, 0, f.distal * length);
  add_tip(assembly, name + "_tip", chain.end, 1 + static_cast<int>(std::lround(3 * share)),
          shape.fingers == kFingerCount ? kUnknown : share);
  assembly.chains.push_back(std::move(chain));
}

RobotModel finalized_table(Assembly& assembly) {
  finalize_robot(assembly);
  assert(assembly.problems.none());
  return std::move(assembly.table);
}

}  // namespace

void add_generated_arm(Assembly& assembly, const MountPoint& base, const ArmSpec& shape) {
  const double link_length = shape.length / (shape.joints / 3);
  Chain chain{"arm", true, {}, {}, base};
  for (int k = 0; k < shape.joints; ++k) {
    chain.end =
        add_revolute_joint(assembly, chain, fmt::format("arm_{}", k + 1), chain.end,
                           Vec3::Unit(k % 3), joint_limits(shape, -shape.limit, shape.limit));
    if (k % 3 == 0) chain.hinges.push_back(chain.end.frame);
    if (k % 3 != 2) continue;
    const int link = add_capsule(assembly, fmt::format("arm_link_{}", k / 3 + 1), chain.end,
                                 link_length, shape.radius, false);
    if (k > 2) allow_capsule_pair(assembly, link - 1, link);
    chain.end = translated(chain.end, 0, 0, link_length);
  }
  // The wrist has a frame of its own, even if it has no joint.
  chain.end = {add_fixed(assembly, "wrist", chain.end)};
  if (shape.joints % 3 == 0) chain.hinges.push_back(chain.end.frame);
  add_tip(assembly, "wrist", chain.end, -1, kUnknown);
  assembly.palm = "wrist";
  assembly.chains.push_back(std::move(chain));
}

void add_generated_hand(Assembly& assembly, const MountPoint& base, const HandSpec& shape) {
  const MountPoint palm{add_fixed(assembly, "palm", base)};
  const int first_metacarpal = capsule_count(assembly);
  for (int number = 1; number < shape.fingers; ++number)
    add_metacarpal(assembly, shape, palm, number);
  add_thumb(assembly, shape, palm);
  for (int number = 1; number < shape.fingers; ++number)
    add_finger(assembly, shape, palm, first_metacarpal, number);
  assembly.palm = "palm";
}

RobotModel generate_arm(const ArmSpec& shape) {
  Assembly assembly;
  assembly.table.name = fmt::format("arm{}", shape.joints);
  add_generated_arm(assembly, {}, shape);
  return finalized_table(assembly);
}

RobotModel generate_hand(const HandSpec& shape) {
  Assembly assembly;
  assembly.table.name = fmt::format("hand{}", shape.fingers);
  add_generated_hand(assembly, {}, shape);
  return finalized_table(assembly);
}

RobotModel generate_arm_hand(const ArmSpec& arm, const HandSpec& hand,
                             const Pose& wrist_from_palm) {
  Assembly assembly;
  assembly.table.name = fmt::format("arm{}_hand{}", arm.joints, hand.fingers);
  add_generated_arm(assembly, {}, arm);
  const MountPoint end{assembly.chains.back().end.frame, wrist_from_palm};
  remove_parent_wrist_tip(assembly, end);
  add_generated_hand(assembly, end, hand);
  return finalized_table(assembly);
}

}  // namespace morphe::robot
