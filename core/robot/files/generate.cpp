#include "core/robot/files/generate.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "core/motion/human_motion.hpp"
#include "core/robot/files/assembly.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::robot {
namespace {

struct Speed {
  double velocity, acceleration, jerk;
};

/// A frame whose z is the axis (± x, y or z), as of every DH joint: exact, and fast to turn.
Pose frame_about(const Vec3& axis) {
  Eigen::Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  Pose pose = Pose::Identity();
  pose.linear().col(0) = Vec3::Unit((along + 1) % 3);
  pose.linear().col(1) = axis.cross(pose.linear().col(0));
  pose.linear().col(2) = axis;
  return pose;
}

/// Adds a driven joint that turns about `axis` at the end of `place`; returns where it leads.
Anchor add_turn(Assembly& assembly, Chain& chain, const std::string& name, const Anchor& place,
                const Vec3& axis, double lower, double upper, const Speed& speed) {
  RobotTable::Frame frame;
  frame.name = name;
  frame.parent = place.frame;
  const Pose about = frame_about(axis);
  frame.transform = place.frame_from_anchor * about;
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

Anchor moved(Anchor place, double x, double y, double z) {
  place.frame_from_anchor = place.frame_from_anchor * Eigen::Translation3d(x, y, z);
  return place;
}

Anchor turned(Anchor place, double angle, const Vec3& axis) {
  place.frame_from_anchor = place.frame_from_anchor * Eigen::AngleAxisd(angle, axis);
  return place;
}

int add_fixed(Assembly& assembly, const std::string& name, const Anchor& place) {
  RobotTable::Frame frame;
  frame.name = name;
  frame.parent = place.frame;
  frame.transform = place.frame_from_anchor;
  assembly.table.frames.push_back(std::move(frame));
  return static_cast<int>(assembly.table.frames.size()) - 1;
}

void add_tip(Assembly& assembly, const std::string& name, const Anchor& place, int finger,
             double along) {
  assembly.table.tips.push_back({name, place.frame, place.frame_from_anchor, finger, along});
}

/// A capsule along z of a place, if the radius is one; returns its number, -1 if none.
int add_capsule(Assembly& assembly, const std::string& name, const Anchor& place, double length,
                double radius, bool hand) {
  if (!(radius > 0)) return -1;
  RobotTable::Capsule capsule{name,
                              place.frame,
                              place.frame_from_anchor * Vec3::Zero().eval(),
                              place.frame_from_anchor * Vec3(0, 0, length),
                              radius,
                              hand};
  assembly.table.capsules.push_back(std::move(capsule));
  return static_cast<int>(assembly.table.capsules.size()) - 1;
}

/// Capsules that meet where more than one joint connects them.
void allow_meeting(Assembly& assembly, int one, int other) {
  if (one < 0 || other < 0) return;
  assembly.table.allowed_pairs.push_back({std::min(one, other), std::max(one, other)});
}

/// The finger at `share` of the way from index (0) to little (1), between its neighbours.
FingerProportions finger_between(double share) {
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

const Vec3 kFlexing = Vec3::UnitY();  ///< curls towards x, out of the palm
const Vec3 kAbducting = -Vec3::UnitX();

void add_thumb(Assembly& assembly, const HandShape& shape, const Anchor& palm) {
  const ThumbProportions& t = kThumbProportions;
  const Speed speed{shape.velocity, shape.acceleration, shape.jerk};
  Chain chain{"thumb", false, {}, {}, {}};
  const auto joint = [&](const char* name, const Anchor& place, const Vec3& axis, std::size_t k) {
    return add_turn(assembly, chain, name, place, axis, t.lower[k], t.upper[k], speed);
  };
  Anchor at = moved(palm, 0, t.across * shape.breadth, t.along * shape.length);
  at = joint("thumb_rotation", at, -Vec3::UnitZ(), 0);
  at = joint("thumb_abduction", turned(at, t.splay, kAbducting), kAbducting, 1);
  const double radius = shape.radius, length = shape.length;
  const int first = static_cast<int>(assembly.table.capsules.size());
  const int metacarpal =
      add_capsule(assembly, "thumb_metacarpal", at, t.metacarpal * length, radius, true);
  // From here on x points out of the thumb's pad: at zero across the palm.
  at = turned(moved(at, 0, 0, t.metacarpal * shape.length), radians(-90), Vec3::UnitZ());
  at = joint("thumb_mcp", at, kFlexing, 2);
  chain.hinges = {chain.frames.front(), at.frame};
  add_capsule(assembly, "thumb_proximal", at, t.proximal * length, radius, true);
  at = joint("thumb_ip", moved(at, 0, 0, t.proximal * length), kFlexing, 3);
  add_capsule(assembly, "thumb_distal", at, t.distal * length, radius, true);
  for (int palm_part = first - shape.fingers + 1; palm_part < first; ++palm_part) {
    if (metacarpal >= 0) allow_meeting(assembly, metacarpal, palm_part);
  }
  chain.end = moved(at, 0, 0, t.distal * shape.length);
  add_tip(assembly, "thumb_tip", chain.end, 0, kNotSeen);
  assembly.chains.push_back(std::move(chain));
}

std::string finger_name(const HandShape& shape, int number) {
  return shape.fingers == static_cast<int>(kFingers) ? kFingerNames[number]
                                                     : fmt::format("finger{}", number);
}

double share_of(const HandShape& shape, int number) {
  return static_cast<double>(number - 1) / (shape.fingers - 2);
}

/// From the wrist's end of the palm to a finger's base.
void add_metacarpal(Assembly& assembly, const HandShape& shape, const Anchor& palm, int number) {
  const FingerProportions f = finger_between(share_of(shape, number));
  const double along = f.along * shape.length, root = std::min(shape.radius, along);
  add_capsule(assembly, finger_name(shape, number) + "_metacarpal",
              moved(palm, 0, f.across * shape.breadth, root), along - root, shape.radius, true);
}

/// `first_palm`: the first of the metacarpals' capsules, if there are any.
void add_finger(Assembly& assembly, const HandShape& shape, const Anchor& palm, int first_palm,
                int number) {
  const double share = share_of(shape, number);
  const FingerProportions f = finger_between(share);
  const Speed speed{shape.velocity, shape.acceleration, shape.jerk};
  const bool human = shape.fingers == static_cast<int>(kFingers);
  const std::string name = finger_name(shape, number);
  Chain chain{name, false, {}, {}, {}};
  const auto joint = [&](const char* what, const Anchor& place, const Vec3& axis, std::size_t k) {
    return add_turn(assembly, chain, name + what, place, axis, f.lower[k], f.upper[k], speed);
  };
  const double length = shape.length;
  Anchor at = moved(palm, 0, f.across * shape.breadth, f.along * length);
  at = joint("_abduction", turned(at, -f.splay, kAbducting), kAbducting, 0);
  at = joint("_mcp", at, kFlexing, 1);
  const auto phalanx = [&](const char* what, double share_of_hand) {
    return add_capsule(assembly, name + what, at, share_of_hand * length, shape.radius, true);
  };
  const int proximal = phalanx("_proximal", f.proximal);
  for (int k = 0; k + 1 < shape.fingers; ++k) allow_meeting(assembly, first_palm + k, proximal);
  at = joint("_pip", moved(at, 0, 0, f.proximal * length), kFlexing, 2);
  chain.hinges = {chain.frames.front(), at.frame};
  phalanx("_middle", f.middle);
  at = joint("_dip", moved(at, 0, 0, f.middle * length), kFlexing, 3);
  phalanx("_distal", f.distal);
  chain.end = moved(at, 0, 0, f.distal * length);
  add_tip(assembly, name + "_tip", chain.end, 1 + static_cast<int>(std::lround(3 * share)),
          human ? kNotSeen : share);
  assembly.chains.push_back(std::move(chain));
}

std::string wrong_speed(double velocity, double acceleration, double jerk) {
  return velocity > 0 && acceleration > 0 && jerk > 0
             ? ""
             : "velocity, acceleration and jerk must be above 0";
}

}  // namespace

std::string why_invalid(const ArmShape& shape) {
  if (shape.joints < 6 || shape.joints > 60) return "joints must be 6 … 60";
  if (!(shape.length > 0)) return "length must be above 0";
  if (!(shape.limit > 0)) return "limit must be above 0";
  if (!(shape.radius >= 0)) return "radius must not be negative";
  return wrong_speed(shape.velocity, shape.acceleration, shape.jerk);
}

std::string why_invalid(const HandShape& shape) {
  if (shape.fingers < 3 || shape.fingers > 12) return "fingers must be 3 … 12";
  if (!(shape.length > 0) || !(shape.breadth > 0)) return "length and breadth must be above 0";
  if (!(shape.radius >= 0)) return "radius must not be negative";
  return wrong_speed(shape.velocity, shape.acceleration, shape.jerk);
}

void add_generated_arm(Assembly& assembly, const Anchor& base, const ArmShape& shape) {
  assert(why_invalid(shape).empty());
  const Speed speed{shape.velocity, shape.acceleration, shape.jerk};
  const int spherical = shape.joints / 3;
  const Vec3 axes[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  Chain chain{"arm", true, {}, {}, base};
  for (int k = 0; k < shape.joints; ++k) {
    const std::string name = fmt::format("arm_{}", k + 1);
    const bool first = k % 3 == 0;
    chain.end =
        add_turn(assembly, chain, name, chain.end, axes[k % 3], -shape.limit, shape.limit, speed);
    if (first) chain.hinges.push_back(chain.end.frame);
    if (k % 3 != 2) continue;
    const int link = add_capsule(assembly, fmt::format("arm_link_{}", k / 3 + 1), chain.end,
                                 shape.length / spherical, shape.radius, false);
    if (k > 2) allow_meeting(assembly, link - 1, link);
    chain.end = moved(chain.end, 0, 0, shape.length / spherical);
  }
  // The wrist is a place of its own, whether or not a joint stands there.
  chain.end = {add_fixed(assembly, "wrist", chain.end)};
  if (shape.joints % 3 == 0) chain.hinges.push_back(chain.end.frame);
  add_tip(assembly, "wrist", chain.end, -1, kNotSeen);
  assembly.palm = "wrist";
  assembly.chains.push_back(std::move(chain));
}

void add_generated_hand(Assembly& assembly, const Anchor& base, const HandShape& shape) {
  assert(why_invalid(shape).empty());
  const Anchor palm{add_fixed(assembly, "palm", base)};
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

RobotTable finished_table(Assembly& assembly) {
  finish(assembly);
  assert(assembly.problems.none());
  return std::move(assembly.table);
}

}  // namespace

RobotTable generate_arm(const ArmShape& shape) {
  Assembly assembly;
  assembly.table.name = fmt::format("arm{}", shape.joints);
  add_generated_arm(assembly, {}, shape);
  return finished_table(assembly);
}

RobotTable generate_hand(const HandShape& shape) {
  Assembly assembly;
  assembly.table.name = fmt::format("hand{}", shape.fingers);
  add_generated_hand(assembly, {}, shape);
  return finished_table(assembly);
}

RobotTable generate_arm_hand(const ArmShape& arm, const HandShape& hand,
                             const Pose& wrist_from_palm) {
  Assembly assembly;
  assembly.table.name = fmt::format("arm{}_hand{}", arm.joints, hand.fingers);
  add_generated_arm(assembly, {}, arm);
  const Anchor end{assembly.chains.back().end.frame, wrist_from_palm};
  drop_carriers_wrist(assembly, end);
  add_generated_hand(assembly, end, hand);
  return finished_table(assembly);
}

}  // namespace morphe::robot
