#include "stages/simulate/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "stages/simulate/plan_lift.hpp"

namespace morphe::simulate {
namespace {

/// Share of a motor's torque limit from which it counts as at the limit.
constexpr double kTorqueLimitRatio = 0.999;

/// Returns the height of a hand's base, along the same curve as the palm's in plan_lift().
double base_height(const ServoCommands& program, Eigen::Index row) {
  const double progress = static_cast<double>(row + 1 - program.grasp_end) /
                          static_cast<double>(program.lift_end - program.grasp_end);
  return kLiftHeight_m * minimum_jerk(std::clamp(progress, 0.0, 1.0));
}

}  // namespace

Simulation::Simulation(const PreparedPlan& plan, const Variation& variation,
                       const SimulateOptions& options, Environment environment)
    : plan_(plan),
      model_(mjcf_text(plan.world, variation, options, environment)),
      parts_(model_, *plan.robot, plan.world.lifts_base),
      state_(model_),
      motor_frames_(motor_frames(*plan.robot)) {}

void Simulation::start() {
  const RobotModel& robot = *plan_.robot;
  for (int f = 0; f < std::ssize(robot.frames); ++f) {
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint >= 0)
      state_.set_joint(parts_.joints[f],
                       frame.ratio * plan_.program.start[frame.joint] + frame.offset);
  }
  state_.update_poses();
}

std::optional<std::string> Simulation::step(Eigen::Index row) {
  for (int j = 0; j < std::ssize(parts_.motors); ++j) {
    const RobotModel::Frame& motor = motor_of(j);
    state_.set_control(parts_.motors[j],
                       motor.ratio * plan_.program.control(row, j) + motor.offset);
  }
  set_feedforward_acceleration(row);
  if (parts_.base_motor >= 0)
    state_.set_control(parts_.base_motor, base_height(plan_.program, row));
  std::optional<std::string> problem = state_.step();
  if (!problem) update_torque_ratio();
  return problem;
}

double Simulation::tracking_error(int joint, Eigen::Index row) const {
  const RobotModel::Frame& motor = motor_of(joint);
  const double position =
      (state_.joint(parts_.joints[motor_frames_[joint]]) - motor.offset) / motor.ratio;
  return std::abs(position - plan_.program.reference(row, joint)) *
         (motor.prismatic ? 1000 : 1 / kRadPerDegree);
}

void Simulation::set_feedforward_acceleration(Eigen::Index row) {
  const RobotModel& robot = *plan_.robot;
  for (int f = 0; f < std::ssize(robot.frames); ++f) {
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint >= 0)
      state_.set_acceleration(parts_.joints[f],
                              frame.ratio * plan_.program.acceleration(row, frame.joint));
  }
}

void Simulation::update_torque_ratio() {
  finger_at_limit_ = false;
  for (int j = 0; j < std::ssize(parts_.motors); ++j) {
    const int motor = parts_.motors[j];
    const double limit = plan_.world.servos[j].torque_limit;
    torque_ratio_ = std::max(torque_ratio_, std::abs(state_.applied_force(motor)) / limit);
    if (std::ranges::count(plan_.robot->arm_joints, j) > 0) continue;
    if (std::abs(state_.commanded_force(motor)) >= kTorqueLimitRatio * limit)
      finger_at_limit_ = true;
  }
}

HoldResult engine_failure(const std::string& message) {
  HoldResult result;
  result.failure = Failure::engine_error;
  result.detail = message;
  return result;
}

}  // namespace morphe::simulate
