#include "pipeline/setup/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "pipeline/setup/published_limits.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kAccelerationPerVelocity = 3, kJerkPerAcceleration = 50;  // [1/s]
constexpr double kDefaultVelocity_rad_s = 1, kDefaultVelocity_m_s = 0.1;   // [rad/s], [m/s]
/// Velocities above these are a motor's without load. Chosen by hand: the fastest published joints
/// are those of the LEAP Hand (8.5 rad/s) and of the Research 3 (5.3 rad/s); humanoids' files have
/// 20 to 37 rad/s.
constexpr double kMaxBelievedVelocity_rad_s = 10, kMaxBelievedVelocity_m_s = 2;
constexpr double kLoadedVelocity_rad_s =
    3.14;  ///< as of UR5e and xArm 7; published arms 1.3 to 5.3

/// Returns the joints of the first seven moving frames, which are those of an arm.
std::vector<int> seven_joints(const Kinematics& robot) {
  std::vector<int> joints;
  for (int f = 0; f < std::ssize(robot.table().frames) && joints.size() < 7; ++f)
    if (robot.moves(f)) joints.push_back(robot.frame(f).joint);
  return joints;
}

const PublishedArm* find_published_arm(const Kinematics& robot) {
  const std::string names =
      lower_case(robot.model->name + "\n" + robot.table().joint_names.front());
  for (const PublishedArm& arm : kPublishedArms) {
    if (names.find(arm.name) != std::string::npos && seven_joints(robot).size() == 7) return &arm;
  }
  return nullptr;
}

/// Sets the velocity if that of the URDF is missing or not believed.
void set_velocity(const robot::UrdfJoint& joint, JointLimits& own) {
  if (!joint.velocity) {
    own.velocity = own.prismatic ? kDefaultVelocity_m_s : kDefaultVelocity_rad_s;
  } else if (*joint.velocity >
             (own.prismatic ? kMaxBelievedVelocity_m_s : kMaxBelievedVelocity_rad_s)) {
    own.motor_velocity = *joint.velocity;
    own.velocity = own.prismatic ? kDefaultVelocity_m_s : kLoadedVelocity_rad_s;
  }
}

}  // namespace

std::vector<JointLimits> joint_limits(const Kinematics& robot, const robot::GivenLimits& given) {
  const RobotModel& table = robot.table();
  std::vector<bool> slides(table.joints(), false), seen(table.joints(), false);
  for (const RobotModel::Frame& frame : table.frames) {
    if (frame.joint < 0 || seen[frame.joint]) continue;
    seen[frame.joint] = true;
    slides[frame.joint] = frame.prismatic;
  }
  const PublishedArm* arm = find_published_arm(robot);
  const std::vector<int> seven = seven_joints(robot);
  std::vector<JointLimits> limits;
  for (int j = 0; j < std::ssize(table.joint_names); ++j) {
    const robot::UrdfJoint& joint = *robot.model->joint(table.joint_names[j]);
    JointLimits own;
    own.joint = joint.name;
    own.prismatic = slides[j];
    own.position_given = given.contains(own.joint);
    if (own.position_given || (!joint.lower && joint.kind != robot::JointKind::continuous)) {
      own.lower = table.lower[j];
      own.upper = table.upper[j];
    }
    set_velocity(joint, own);
    own.acceleration = kAccelerationPerVelocity * own.velocity.value_or(joint.velocity.value_or(1));
    own.jerk = kJerkPerAcceleration * own.acceleration;
    const auto k = std::ranges::find(seven, j) - seven.begin();
    if (arm && k < std::ssize(seven)) {
      own.acceleration = arm->acceleration[k];
      own.jerk = arm->jerk[k] > 0 ? arm->jerk[k] : kJerkPerAcceleration * own.acceleration;
      own.sure = Provenance::read;
      own.source = arm->source;
      const PublishedArm::Braking& braking = arm->braking[k];
      if (braking.twice_deceleration > 0)
        own.braking = {j, braking.twice_deceleration, braking.velocity_offset, braking.lower_end,
                       braking.upper_end};
    }
    limits.push_back(own);
  }
  return limits;
}

std::vector<std::string> locked_joints(const robot::UrdfModel& model) {
  std::vector<std::string> locked;
  for (const robot::UrdfJoint& joint : model.tree.joints) {
    const bool freed =
        std::ranges::find(model.table.joint_names, joint.name) != model.table.joint_names.end();
    if (joint.lower && *joint.lower == *joint.upper && !freed) locked.push_back(joint.name);
  }
  return locked;
}

namespace {

/// Names of joints by the remark on them, in the order of the joints.
using Remarked = std::vector<std::pair<std::string, std::vector<std::string>>>;

void add_name(Remarked& groups, const std::string& remark, const std::string& joint) {
  auto group = std::ranges::find(groups, remark, &Remarked::value_type::first);
  if (group == groups.end()) group = groups.insert(groups.end(), {remark, {}});
  group->second.push_back(joint);
}

std::string text_of(const Remarked& groups) {
  std::vector<std::string> texts;
  for (const auto& [remark, names] : groups)
    texts.push_back(fmt::format("{}{}", fmt::join(names, ", "),
                                remark.empty() ? "" : fmt::format(" ({})", remark)));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::vector<std::string> limit_items(const robot::UrdfModel& model,
                                     const std::vector<JointLimits>& limits,
                                     const std::set<std::string>& joints) {
  Remarked unbounded, slow, motors, locked;
  for (const JointLimits& own : limits) {
    if (!joints.contains(own.joint)) continue;
    const char* unit = own.prismatic ? "m" : "rad";
    if (own.lower && !own.position_given)
      add_name(unbounded, fmt::format("{:.3g} to {:.3g} {}", *own.lower, *own.upper, unit),
               own.joint);
    if (own.velocity && own.motor_velocity == 0)
      add_name(slow, fmt::format("{:g} {}/s", *own.velocity, unit), own.joint);
    if (own.motor_velocity > 0)
      add_name(
          motors,
          fmt::format("{:.3g} instead of {:.3g} {}/s", *own.velocity, own.motor_velocity, unit),
          own.joint);
  }
  for (const std::string& joint : locked_joints(model))
    if (joints.contains(joint)) add_name(locked, "", joint);
  std::vector<std::string> items;
  const auto add = [&](const Remarked& groups, const char* sentence) {
    if (!groups.empty()) items.push_back(fmt::format("{}: {}", text_of(groups), sentence));
  };
  add(unbounded,
      "limits of position that the URDF lacks are assumed (--limit JOINT=LOWER..UPPER gives them)");
  add(slow, "velocities that are 0 or missing in the URDF are assumed (urdf.limits gives them)");
  add(motors,
      "velocities are assumed, since those of the URDF are a motor's without load, or in degrees "
      "(urdf.limits gives them)");
  add(locked,
      "locked by the URDF, lower = upper, and held there (--limit JOINT=LOWER..UPPER frees it)");
  return items;
}

}  // namespace morphe::setup
