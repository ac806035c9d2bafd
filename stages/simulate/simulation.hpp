#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/physics/state.hpp"
#include "stages/simulate/hold_monitor.hpp"
#include "stages/simulate/prepared_plan.hpp"

namespace morphe::simulate {

inline constexpr int kMonitorIntervalSteps = 5;  ///< between two evaluations of the target

/// A simulation of a prepared plan, which must outlive it: the robot executes the commands row by
/// row.
class Simulation {
 public:
  Simulation(const PreparedPlan& plan, const Variation& variation, const SimulateOptions& options,
             Environment environment);

  /// Moves the robot to the posture before the first step.
  void start();
  /// Executes one row of the commands; returns the engine's problem, if there is one.
  std::optional<std::string> step(Eigen::Index row);
  /// Returns the deviation of a joint from the planned position after a row [degrees; mm].
  double tracking_error(int joint, Eigen::Index row) const;

  Pose target() const { return state_.body(parts_.target_body); }
  physics::State& state() { return state_; }
  const ModelIds& parts() const { return parts_; }
  double torque_ratio() const { return torque_ratio_; }
  bool finger_at_limit() const { return finger_at_limit_; }

 private:
  const RobotModel::Frame& motor_of(int joint) const {
    return plan_.robot->frames[motor_frames_[joint]];
  }
  void set_feedforward_acceleration(Eigen::Index row);
  void update_torque_ratio();

  const PreparedPlan& plan_;
  physics::Model model_;
  ModelIds parts_;
  physics::State state_;
  std::vector<int> motor_frames_;
  double torque_ratio_ = 0;
  bool finger_at_limit_ = false;
};

/// Returns the result of a simulation that the engine ended.
HoldResult engine_failure(const std::string& message);

}  // namespace morphe::simulate
