#include "stages/simulate/servos.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace morphe::simulate {
namespace {

struct ArmServo {
  double stiffness, velocity_gain, armature, torque_limit;
};
constexpr std::array<ArmServo, 7> kPa10Servos{{{4000, 400, 0.75, 158},
                                               {4000, 400, 0.75, 158},
                                               {3000, 200, 0.2125, 68},
                                               {3000, 200, 0.2125, 68},
                                               {800, 20, 0.00575, 17},
                                               {800, 20, 0.00575, 17},
                                               {500, 15, 0.00575, 17}}};
constexpr double kHandArmature = 0.001, kHandDamping = 0.02;
// A prismatic joint of arm or hand. ASSUMPTION: a gripper's values.
constexpr ArmServo kPrismaticServo{5000, 100, 0.3, 60};

void override_gains(const ServoGains& gains, Servo& servo) {
  servo.stiffness = gains.stiffness.value_or(servo.stiffness);
  servo.velocity_gain = gains.velocity_gain.value_or(servo.velocity_gain);
  servo.armature = gains.armature.value_or(servo.armature);
  servo.damping = gains.damping.value_or(servo.damping);
  servo.torque_limit = gains.torque_limit.value_or(servo.torque_limit);
}

}  // namespace

std::vector<int> motor_frames(const RobotModel& robot) {
  std::vector<int> frames(robot.joints(), -1);
  for (std::size_t f = robot.frames.size(); f-- > 0;) {
    if (robot.frames[f].joint >= 0) frames[robot.frames[f].joint] = static_cast<int>(f);
  }
  return frames;
}

std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options) {
  std::vector<Servo> servos(robot.joints());
  std::size_t place = 0;
  const std::vector<int> motors = motor_frames(robot);
  for (std::size_t j = 0; j < servos.size(); ++j) {
    Servo& servo = servos[j];
    const RobotModel::Frame& motor = robot.frames[motors[j]];
    if (motor.prismatic) {
      servo = {kPrismaticServo.stiffness, kPrismaticServo.velocity_gain, kPrismaticServo.armature,
               0, kPrismaticServo.torque_limit};
    } else if (std::ranges::count(robot.arm_joints, static_cast<int>(j)) > 0) {
      const ArmServo& arm = kPa10Servos[std::min(place++, kPa10Servos.size() - 1)];
      servo = {arm.stiffness, arm.velocity_gain, arm.armature, 0, arm.torque_limit};
    } else {
      // Critically damped with the motor's inertia alone.
      const double critical = 2 * std::sqrt(options.hand_stiffness * kHandArmature);
      servo = {options.hand_stiffness, critical, kHandArmature, kHandDamping,
               options.hand_torque_limit};
    }
    if (const auto gains = options.servos.find(robot.joint_names[j]); gains != options.servos.end())
      override_gains(gains->second, servo);
    double damping = 0;  // of all frames that the joint moves
    for (const RobotModel::Frame& frame : robot.frames) {
      if (frame.joint == static_cast<int>(j))
        damping += servo.damping * std::pow(frame.ratio / motor.ratio, 2);
    }
    servo.lead_s = (servo.velocity_gain + damping) / servo.stiffness;
  }
  return servos;
}

}  // namespace morphe::simulate
