#include "stages/simulate/servos.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace morphe::simulate {
namespace {

/// Servos of the PA10 in order from the base (MuJoCo models of it).
constexpr std::array<Servo, 7> kPa10Servos{{{4000, 400, 0.75, 0, 158},
                                            {4000, 400, 0.75, 0, 158},
                                            {3000, 200, 0.2125, 0, 68},
                                            {3000, 200, 0.2125, 0, 68},
                                            {800, 20, 0.00575, 0, 17},
                                            {800, 20, 0.00575, 0, 17},
                                            {500, 15, 0.00575, 0, 17}}};
constexpr double kHandArmature = 0.001, kHandDamping = 0.02;
/// A prismatic joint of arm or hand. ASSUMPTION: a gripper's values.
constexpr Servo kPrismaticServo{5000, 100, 0.3, 0, 60};

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
  for (int f = 0; f < std::ssize(robot.frames); ++f) {
    const int joint = robot.frames[f].joint;
    if (joint >= 0 && frames[joint] < 0) frames[joint] = f;
  }
  return frames;
}

std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options) {
  std::vector<Servo> servos(robot.joints());
  std::size_t arm_position = 0;
  const std::vector<int> motors = motor_frames(robot);
  for (int j = 0; j < std::ssize(servos); ++j) {
    Servo& servo = servos[j];
    const RobotModel::Frame& motor = robot.frames[motors[j]];
    if (motor.prismatic) {
      servo = kPrismaticServo;
    } else if (std::ranges::count(robot.arm_joints, j) > 0) {
      servo = kPa10Servos[std::min(arm_position++, kPa10Servos.size() - 1)];
    } else {
      // Critically damped with the motor's inertia alone.
      const double critical = 2 * std::sqrt(options.hand_stiffness * kHandArmature);
      servo = {options.hand_stiffness, critical, kHandArmature, kHandDamping,
               options.hand_torque_limit};
    }
    if (const auto gains = options.servos.find(robot.joint_names[j]); gains != options.servos.end())
      override_gains(gains->second, servo);
    double damping = 0;  // of all frames that the joint moves
    for (const RobotModel::Frame& frame : robot.frames)
      if (frame.joint == j) damping += servo.damping * std::pow(frame.ratio / motor.ratio, 2);
    servo.lead_s = (servo.velocity_gain + damping) / servo.stiffness;
  }
  return servos;
}

}  // namespace morphe::simulate
