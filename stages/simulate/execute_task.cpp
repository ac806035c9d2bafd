#include "stages/simulate/execute_task.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::simulate {
namespace {

class TaskExecution {
 public:
  TaskExecution(const PreparedPlan& plan, const SimulateOptions& options, Simulation& simulation)
      : plan_(plan),
        options_(options),
        simulation_(simulation),
        monitor_(*plan.robot, simulation.parts(), simulation.state(), false),
        start_height_m_(target_height()) {}

  TaskResult execute() {
    carry();
    if (result_.failure != Failure::none) return result_;
    result_.carried_error = error_of_place();
    run(plan_.program.carry_end, plan_.program.release_end);
    const Displacement released_error = error_of_place();
    run(plan_.program.release_end, plan_.program.leave_end);
    const Pose left = simulation_.target();
    run(plan_.program.leave_end, plan_.program.stand_end);
    if (result_.failure != Failure::none) return result_;  // of the engine
    result_.place_error = error_of_place();
    result_.tilt_deg = tilt_deg();
    result_.standing_motion = displacement_between(left, simulation_.target());
    result_.failure = final_failure(released_error);
    return result_;
  }

  const HoldResult& hold() const { return hold_; }

 private:
  /// Executes rows, calling `watch` after each of them, until it returns false or the engine fails.
  template <class Watch>
  void run(Eigen::Index from, Eigen::Index to, Watch watch) {
    for (Eigen::Index row = from; row < to && result_.failure == Failure::none; ++row) {
      if (const auto problem = simulation_.step(row)) {
        hold_ = engine_failure(*problem);
        result_.failure = hold_.failure;
      } else if (!watch(row)) {
        return;
      }
    }
  }
  void run(Eigen::Index from, Eigen::Index to) {
    run(from, to, [](Eigen::Index) { return true; });
  }

  void carry() {
    result_.rise_m = result_.arm_error = 0;
    result_.palm_offset = {};
    const Eigen::Index from = plan_.program.grasp_end, to = plan_.program.carry_end;
    run(from, to, [&](Eigen::Index row) {
      for (const int j : plan_.robot->arm_joints)
        result_.arm_error = std::max(result_.arm_error, simulation_.tracking_error(j, row));
      if ((row + 1) % kMonitorIntervalSteps != 0 && row + 1 != to) return true;
      const bool settled = static_cast<double>(row + 1 - from) * options_.step_s >= kDroopTime_s;
      monitor_.update(simulation_.state(), settled, simulation_.finger_at_limit());
      result_.rise_m = std::max(result_.rise_m, target_height() - start_height_m_);
      update_maximum(
          displacement_between(plan_.palm_from_target,
                               palm_from_target(simulation_.state(), simulation_.parts())),
          result_.palm_offset);
      return !monitor_.failed();
    });
    if (result_.failure != Failure::none) return;  // of the engine
    hold_ = monitor_.result();
    result_.failure = hold_.failure;
    if (hold_.is_held() && result_.rise_m < kMinRiseShare * plan_.task->rise_m)
      result_.failure = Failure::not_lifted;
  }

  /// Returns the first cause for which the target does not stand as planned, let go of.
  Failure final_failure(const Displacement& released_error) {
    const auto is_far = [](const Displacement& error) {
      return error.distance_m > kMaxPlaceError_m;
    };
    if (is_far(result_.place_error)) {
      if (is_far(result_.carried_error)) return Failure::misplaced;
      return is_far(released_error) ? Failure::displaced_while_releasing
                                    : Failure::displaced_while_leaving;
    }
    if (result_.tilt_deg > kMaxTilt_deg) return Failure::tilted;
    if (!plan_.task->lets_go) return Failure::none;
    std::vector<physics::GeomContact> touches;
    if (!target_contacts(simulation_.state(), simulation_.parts(), touches).empty())
      return Failure::not_released;
    const bool moves = result_.standing_motion.distance_m >= kMaxDrift_m ||
                       result_.standing_motion.angle_deg >= kMaxDrift_deg;
    return moves ? Failure::still_moving : Failure::none;
  }

  Displacement error_of_place() const {
    return displacement_between(plan_.task->base_from_placed, simulation_.target());
  }
  /// Returns the angle between the directions in the target that are and should be vertical.
  double tilt_deg() const {
    const Vec3 is = simulation_.target().linear().transpose() * plan_.world.up;
    const Vec3 should_be = plan_.task->base_from_placed.linear().transpose() * plan_.world.up;
    return std::acos(std::clamp(is.dot(should_be), -1.0, 1.0)) / kRadPerDegree;
  }
  double target_height() const {
    return lowest_height(plan_.world.scene->objects[plan_.world.target], simulation_.target(),
                         plan_.world.up);
  }

  const PreparedPlan& plan_;
  const SimulateOptions& options_;
  Simulation& simulation_;
  HoldMonitor monitor_;
  const double start_height_m_;
  HoldResult hold_;
  TaskResult result_;
};

}  // namespace

void execute_task(const PreparedPlan& plan, const SimulateOptions& options, Simulation& simulation,
                  Rollout& rollout) {
  TaskExecution execution(plan, options, simulation);
  rollout.task = execution.execute();
  rollout.lift = execution.hold();
}

}  // namespace morphe::simulate
