#include "pipeline/setup/limits.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "pipeline/setup/published_limits.hpp"

namespace morphe::setup {
namespace {

constexpr double kAccelerationPerVelocity = 3, kJerkPerAcceleration = 50;  // [1/s]
constexpr double kDefaultVelocity_rad_s = 1, kDefaultVelocity_m_s = 0.1;   // [rad/s], [m/s]

bool contains_word(const std::string& text, std::string_view word) {
  std::string lower = text;
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find(word) != std::string::npos;
}

/// Returns the first seven consecutive joints from the base, which are those of an arm.
std::vector<int> seven_joints(const Kinematics& robot) {
  std::vector<int> joints;
  for (std::size_t f = 0; f < robot.table().frames.size() && joints.size() < 7; ++f) {
    if (robot.moves(static_cast<int>(f))) joints.push_back(robot.frame(static_cast<int>(f)).joint);
  }
  return joints;
}

const PublishedArm* find_published_arm(const Kinematics& robot) {
  for (const PublishedArm& arm : kPublishedArms) {
    const bool named = contains_word(robot.model->name, arm.name) ||
                       contains_word(robot.table().joint_names.front(), arm.name);
    if (named && seven_joints(robot).size() == 7) return &arm;
  }
  return nullptr;
}

}  // namespace

std::vector<JointLimits> joint_limits(const Kinematics& robot) {
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
  for (std::size_t j = 0; j < table.joints(); ++j) {
    const robot::UrdfJoint& joint = *robot.model->joint(table.joint_names[j]);
    JointLimits own;
    own.joint = joint.name;
    if (!joint.lower && joint.kind != robot::JointKind::continuous) {
      own.lower = table.lower[j];
      own.upper = table.upper[j];
    }
    if (!joint.velocity) own.velocity = slides[j] ? kDefaultVelocity_m_s : kDefaultVelocity_rad_s;
    own.acceleration = kAccelerationPerVelocity * joint.velocity.value_or(own.velocity.value_or(1));
    own.jerk = kJerkPerAcceleration * own.acceleration;
    const auto at = std::ranges::find(seven, static_cast<int>(j));
    if (arm && at != seven.end()) {
      const auto k = static_cast<std::size_t>(at - seven.begin());
      own.acceleration = arm->acceleration[k];
      own.jerk = arm->jerk[k] > 0 ? arm->jerk[k] : kJerkPerAcceleration * own.acceleration;
      own.sure = Provenance::read;
      own.source = arm->source;
      const PublishedArm::Braking& braking = arm->braking[k];
      if (braking.slope > 0) {
        own.braking = {static_cast<int>(j), braking.slope, braking.drop, braking.lower_end,
                       braking.upper_end};
      }
    }
    limits.push_back(own);
  }
  return limits;
}

}  // namespace morphe::setup
