#include "core/robot/files/generate.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "core/motion/human_motion.hpp"
#include "core/robot/files/assembly.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::robot {
namespace {

struct RateLimits {
  double velocity, acceleration, jerk;
};

/// Returns a frame whose z axis is the joint axis (± x, y or z), as in DH joints: exact and fast to
/// rotate.
Pose frame_about(const Vec3& axis) {
  Eigen::Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = Vec3::Unit((along + 1) % 3);
  pose.linear().col(1) = axis.cross(pose.linear().col(0));
  pose.linear().col(2) = axis;
  return pose;
}

/// Adds a driven revolute joint about `axis` at `place`; returns the mount point that it moves.
MountPoint add_revolute_joint(Assembly& assembly, Chain& chain, const std::string& name,
                              const MountPoint& place, const Vec3& axis, double lower, double upper,
                              const RateLimits& speed) {
  RobotModel::Frame frame;
  frame.name = name;
  frame.parent = place.frame;
  const Pose about = frame_about(axis);
  frame.transform = place.frame_from_mount * about;
  frame.joint = static_cast<int>(assembly.table.joint_names.size());
  assembly.table.joint_names.push_back(name);
  assembly.lower.push_back(lower);
  assembly.upper.push_back(upper);
  assembly.velocity.push_back(speed.velocity);
  assembly.acceleration.push_back(speed.acceleration);
  assembly.jerk.push_back(speed.jerk);
  assembly.table.frames.push_back(std::move(frame));
  chain.frames.push_back(static_cast<int>(assembly.table.frames.size()) - 1);
  return {chain.frames.back(), about.inverse()};
}

MountPoint translated(MountPoint place, double x, double y, double z) {
  place.frame_from_mount = place.frame_from_mount * Eigen::Translation3d(x, y, z);
  return place;
}

MountPoint rotated(MountPoint place, double angle, const Vec3& axis) {
  place.frame_from_mount = place.frame_from_mount * Eigen::AngleAxisd(angle, axis);
  return place;
}

int add_fixed(Assembly& assembly, const std::string& name, const MountPoint& place) {
  RobotModel::Frame frame;
  frame.name = name;
  frame.parent = place.frame;
  frame.transform = place.frame_from_mount;
  assembly.table.frames.push_back(std::move(frame));
  return static_cast<int>(assembly.table.frames.size()) - 1;
}

void add_tip(Assembly& assembly, const std::string& name, const MountPoint& place, int finger,
             double along) {
  assembly.table.tips.push_back({name, place.frame, place.frame_from_mount, finger, along});
}

/// Adds a capsule along z of a mount point if the radius is positive; returns its index, or -1.
int add_capsule(Assembly& assembly, const std::string& name, const MountPoint& place, double length,
                double radius, bool hand) {
  if (!(radius > 0)) return -1;
  RobotModel::Capsule capsule{name,
                              place.frame,
                              place.frame_from_mount * Vec3::Zero().eval(),
                              place.frame_from_mount * Vec3(0, 0, length),
                              radius,
                              hand};
  assembly.table.capsules.push_back(std::move(capsule));
  return static_cast<int>(assembly.table.capsules.size()) - 1;
}

/// Allows a collision of capsules that meet although more than one joint connects them.
void allow_capsule_pair(Assembly& assembly, int one, int other) {
  if (one < 0 || other < 0) return;
  assembly.table.allowed_collision_pairs.push_back({std::min(one, other), std::max(one, other)});
}

/// Interpolates the finger at `share` between index (0) and little (1) from its neighbours.
FingerProportions interpolate_finger(double share) {
  const double at = 3 * share;
  const auto before = static_cast<std::size_t>(std::min(2.0, std::floor(at)));
  const double t = at - static_cast<double>(before);
  const FingerProportions& a = kFingerProportions[before];
  const FingerProportions& b = kFingerProportions[before + 1];
  const auto mix = [t](double x, double y) { return t == 1 ? y : x + t * (y - x); };
  FingerProportions f{mix(a.across, b.across),
                      mix(a.along, b.along),
                      mix(a.proximal, b.proximal),
                      mix(a.middle, b.middle),
                      mix(a.distal, b.distal),
                      mix(a.splay, b.splay),
                      {},
                      {}};
  for (std::size_t k = 0; k < f.lower.size(); ++k) {
    f.lower[k] = mix(a.lower[k], b.lower[k]);
    f.upper[k] = mix(a.upper[k], b.upper[k]);
  }
  return f;
}

const Vec3 kFlexionAxis = Vec3::UnitY();  ///< flexes towards x, out of the palm
const Vec3 kAbductionAxis = -Vec3::UnitX();

void add_thumb(Assembly& assembly, const HandSpec& shape, const MountPoint& palm) {
  const ThumbProportions& t = kThumbProportions;
  const RateLimits speed{shape.velocity, shape.acceleration, shape.jerk};
  Chain chain{"thumb", false, {}, {}, {}};
  const auto joint = [&](const char* name, const MountPoint& place, const Vec3& axis,
                         std::size_t k) {
    return add_revolute_joint(assembly, chain, name, place, axis, t.lower[k], t.upper[k], speed);
  };
  MountPoint at = translated(palm, 0, t.across * shape.breadth, t.along * shape.length);
  at = joint("thumb_rotation", at, -Vec3::UnitZ(), 0);
  at = joint("thumb_abduction", rotated(at, t.splay, kAbductionAxis), kAbductionAxis, 1);
  const double radius = shape.radius, length = shape.length;
  const int first = static_cast<int>(assembly.table.capsules.size());
  const int metacarpal =
      add_capsule(assembly, "thumb_metacarpal", at, t.metacarpal * length, radius, true);
  // From here on x points out of the thumb's pad, which at zero is across the palm.
  at = rotated(translated(at, 0, 0, t.metacarpal * shape.length), radians(-90), Vec3::UnitZ());
  at = joint("thumb_mcp", at, kFlexionAxis, 2);
  chain.hinges = {chain.frames.front(), at.frame};
  add_capsule(assembly, "thumb_proximal", at, t.proximal * length, radius, true);
  at = joint("thumb_ip", translated(at, 0, 0, t.proximal * length), kFlexionAxis, 3);
  add_capsule(assembly, "thumb_distal", at, t.distal * length, radius, true);
  for (int palm_part = first - shape.fingers + 1; palm_part < first; ++palm_part) {
    if (metacarpal >= 0) allow_capsule_pair(assembly, metacarpal, palm_part);
  }
  chain.end = translated(at, 0, 0, t.distal * shape.length);
  add_tip(assembly, "thumb_tip", chain.end, 0, kUnknown);
  assembly.chains.push_back(std::move(chain));
}

std::string finger_name(const HandSpec& shape, int number) {
  return shape.fingers == static_cast<int>(kFingerCount) ? kFingerNames[number]
                                                         : fmt::format("finger{}", number);
}

double share_of(const HandSpec& shape, int number) {
  return static_cast<double>(number - 1) / (shape.fingers - 2);
}

/// Adds the metacarpal from the wrist's end of the palm to a finger's base.
void add_metacarpal(Assembly& assembly, const HandSpec& shape, const MountPoint& palm, int number) {
  const FingerProportions f = interpolate_finger(share_of(shape, number));
  const double along = f.along * shape.length, root = std::min(shape.radius, along);
  add_capsule(assembly, finger_name(shape, number) + "_metacarpal",
              translated(palm, 0, f.across * shape.breadth, root), along - root, shape.radius,
              true);
}

/// Adds a finger. `first_palm` is the index of the first capsule of the metacarpals, if they have
/// capsules.
void add_finger(Assembly& assembly, const HandSpec& shape, const MountPoint& palm, int first_palm,
                int number) {
  const double share = share_of(shape, number);
  const FingerProportions f = interpolate_finger(share);
  const RateLimits speed{shape.velocity, shape.acceleration, shape.jerk};
  const bool human = shape.fingers == static_cast<int>(kFingerCount);
  const std::string name = finger_name(shape, number);
  Chain chain{name, false, {}, {}, {}};
  const auto joint = [&](const char* what, const MountPoint& place, const Vec3& axis,
                         std::size_t k) {
    return add_revolute_joint(assembly, chain, name + what, place, axis, f.lower[k], f.upper[k],
                              speed);
  };
  const double length = shape.length;
  MountPoint at = translated(palm, 0, f.across * shape.breadth, f.along * length);
  at = joint("_abduction", rotated(at, -f.splay, kAbductionAxis), kAbductionAxis, 0);
  at = joint("_mcp", at, kFlexionAxis, 1);
  const auto phalanx = [&](const char* what, double share_of_hand) {
    return add_capsule(assembly, name + what, at, share_of_hand * length, shape.radius, true);
  };
  const int proximal = phalanx("_proximal", f.proximal);
  for (int k = 0; k + 1 < shape.fingers; ++k)
    allow_capsule_pair(assembly, first_palm + k, proximal);
  at = joint("_pip", translated(at, 0, 0, f.proximal * length), kFlexionAxis, 2);
  chain.hinges = {chain.frames.front(), at.frame};
  phalanx("_middle", f.middle);
  at = joint("_dip", translated(at, 0, 0, f.middle * length), kFlexionAxis, 3);
  phalanx("_distal", f.distal);
  chain.end = translated(at, 0, 0, f.distal * length);
  add_tip(assembly, name + "_tip", chain.end, 1 + static_cast<int>(std::lround(3 * share)),
          human ? kUnknown : share);
  assembly.chains.push_back(std::move(chain));
}

std::string rate_limit_error(double velocity, double acceleration, double jerk) {
  return velocity > 0 && acceleration > 0 && jerk > 0
             ? ""
             : "velocity, acceleration and jerk must be above 0";
}

}  // namespace

std::string validation_error(const ArmSpec& shape) {
  if (shape.joints < 6 || shape.joints > 60) return "joints must be 6 … 60";
  if (!(shape.length > 0)) return "length must be above 0";
  if (!(shape.limit > 0)) return "limit must be above 0";
  if (!(shape.radius >= 0)) return "radius must not be negative";
  return rate_limit_error(shape.velocity, shape.acceleration, shape.jerk);
}

std::string validation_error(const HandSpec& shape) {
  if (shape.fingers < 3 || shape.fingers > 12) return "fingers must be 3 … 12";
  if (!(shape.length > 0) || !(shape.breadth > 0)) return "length and breadth must be above 0";
  if (!(shape.radius >= 0)) return "radius must not be negative";
  return rate_limit_error(shape.velocity, shape.acceleration, shape.jerk);
}

void add_generated_arm(Assembly& assembly, const MountPoint& base, const ArmSpec& shape) {
  assert(validation_error(shape).empty());
  const RateLimits speed{shape.velocity, shape.acceleration, shape.jerk};
  const int spherical = shape.joints / 3;
  const Vec3 axes[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  Chain chain{"arm", true, {}, {}, base};
  for (int k = 0; k < shape.joints; ++k) {
    const std::string name = fmt::format("arm_{}", k + 1);
    const bool first = k % 3 == 0;
    chain.end = add_revolute_joint(assembly, chain, name, chain.end, axes[k % 3], -shape.limit,
                                   shape.limit, speed);
    if (first) chain.hinges.push_back(chain.end.frame);
    if (k % 3 != 2) continue;
    const int link = add_capsule(assembly, fmt::format("arm_link_{}", k / 3 + 1), chain.end,
                                 shape.length / spherical, shape.radius, false);
    if (k > 2) allow_capsule_pair(assembly, link - 1, link);
    chain.end = translated(chain.end, 0, 0, shape.length / spherical);
  }
  // The wrist has a frame of its own, even if it has no joint.
  chain.end = {add_fixed(assembly, "wrist", chain.end)};
  if (shape.joints % 3 == 0) chain.hinges.push_back(chain.end.frame);
  add_tip(assembly, "wrist", chain.end, -1, kUnknown);
  assembly.palm = "wrist";
  assembly.chains.push_back(std::move(chain));
}

void add_generated_hand(Assembly& assembly, const MountPoint& base, const HandSpec& shape) {
  assert(validation_error(shape).empty());
  const MountPoint palm{add_fixed(assembly, "palm", base)};
  const int first_palm = static_cast<int>(assembly.table.capsules.size());
  for (int number = 1; number < shape.fingers; ++number) {
    add_metacarpal(assembly, shape, palm, number);
  }
  add_thumb(assembly, shape, palm);
  for (int number = 1; number < shape.fingers; ++number) {
    add_finger(assembly, shape, palm, first_palm, number);
  }
  assembly.palm = "palm";
}

namespace {

RobotModel finalized_table(Assembly& assembly) {
  finalize_robot(assembly);
  assert(assembly.problems.none());
  return std::move(assembly.table);
}

}  // namespace

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
