#include "stages/simulate/servos.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace morphe::simulate {
namespace {

struct ArmServo {
  double stiffness, resistance, armature, torque;
};
constexpr std::array<ArmServo, 7> kArm{{{4000, 400, 0.75, 158},
                                        {4000, 400, 0.75, 158},
                                        {3000, 200, 0.2125, 68},
                                        {3000, 200, 0.2125, 68},
                                        {800, 20, 0.00575, 17},
                                        {800, 20, 0.00575, 17},
                                        {500, 15, 0.00575, 17}}};
constexpr double kHandArmature = 0.001, kHandDamping = 0.02;
// A joint that slides, of arm or hand. ASSUMPTION: a gripper's.
constexpr ArmServo kSliding{5000, 100, 0.3, 60};

void take(const ServoGains& gains, Servo& servo) {
  servo.stiffness = gains.stiffness.value_or(servo.stiffness);
  servo.resistance = gains.resistance.value_or(servo.resistance);
  servo.armature = gains.armature.value_or(servo.armature);
  servo.damping = gains.damping.value_or(servo.damping);
  servo.torque = gains.torque.value_or(servo.torque);
}

}  // namespace

std::vector<int> motor_frames(const RobotTable& robot) {
  std::vector<int> frames(robot.joints(), -1);
  for (std::size_t f = robot.frames.size(); f-- > 0;) {
    if (robot.frames[f].joint >= 0)
      frames[static_cast<std::size_t>(robot.frames[f].joint)] = static_cast<int>(f);
  }
  return frames;
}

std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options) {
  std::vector<Servo> servos(robot.joints());
  std::size_t place = 0;
  const std::vector<int> motors = motor_frames(robot);
  for (std::size_t j = 0; j < servos.size(); ++j) {
    Servo& servo = servos[j];
    const RobotTable::Frame& motor = robot.frames[static_cast<std::size_t>(motors[j])];
    if (motor.slides) {
      servo = {kSliding.stiffness, kSliding.resistance, kSliding.armature, 0, kSliding.torque};
    } else if (std::ranges::count(robot.arm_joints, static_cast<int>(j)) > 0) {
      const ArmServo& arm = kArm[std::min(place++, kArm.size() - 1)];
      servo = {arm.stiffness, arm.resistance, arm.armature, 0, arm.torque};
    } else {
      // Aperiodic with the motor's inertia alone.
      const double critical = 2 * std::sqrt(options.hand_stiffness * kHandArmature);
      servo = {options.hand_stiffness, critical, kHandArmature, kHandDamping, options.hand_torque};
    }
    if (const auto gains = options.servos.find(robot.joint_names[j]); gains != options.servos.end())
      take(gains->second, servo);
    double damping = 0;  // of all frames that the joint moves
    for (const RobotTable::Frame& frame : robot.frames) {
      if (frame.joint == static_cast<int>(j))
        damping += servo.damping * std::pow(frame.ratio / motor.ratio, 2);
    }
    servo.lead_s = (servo.resistance + damping) / servo.stiffness;
  }
  return servos;
}

}  // namespace morphe::simulate
