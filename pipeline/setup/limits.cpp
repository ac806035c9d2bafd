#include "pipeline/setup/limits.hpp"

#include <algorithm>

#include "pipeline/setup/published_limits.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kAccelerationPerVelocity = 3, kJerkPerAcceleration = 50;  // [1/s]
constexpr double kDefaultVelocity_rad_s = 1, kDefaultVelocity_m_s = 0.1;   // [rad/s], [m/s]

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
  for (int j = 0; j < std::ssize(table.joint_names); ++j) {
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

}  // namespace morphe::setup
