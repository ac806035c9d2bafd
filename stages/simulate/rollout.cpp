#include "stages/simulate/rollout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/physics/state.hpp"
#include "core/robot/tree.hpp"
#include "stages/simulate/execute_task.hpp"
#include "stages/simulate/force_prediction.hpp"
#include "stages/simulate/simulation.hpp"

namespace morphe::simulate {
namespace {

void update_tracking_error(const PreparedPlan& plan, const Simulation& simulation, Eigen::Index row,
                           Rollout& rollout) {
  for (int j = 0; j < plan.program.reference.cols(); ++j) {
    const bool of_arm = std::ranges::count(plan.robot->arm_joints, j) > 0;
    double& max_error = of_arm ? rollout.arm_error : rollout.hand_error;
    max_error = std::max(max_error, simulation.tracking_error(j, row));
  }
}
std::vector<double> measured_forces(const PreparedPlan& plan,
                                    const std::vector<TargetContact>& contacts) {
  const RobotModel& robot = *plan.robot;
  std::vector<double> forces;
  for (const FingerForce& finger : plan.squeeze.finger_forces) {
    const int link = robot::moving_frame_of(robot, robot.tips[finger.tip].frame);
    double force = 0;
    for (const TargetContact& contact : contacts)
      if (robot::moving_frame_of(robot, robot.capsules[contact.capsule].frame) == link)
        force += contact.force_N;
    forces.push_back(force);
  }
  return forces;
}
Failure grasp_failure(const Rollout& rollout, bool displaced_before, bool opposed) {
  const bool displaced = rollout.pregrasp_displacement.distance_m > kMaxPregraspDisplacement_m;
  if (!displaced && opposed) return Failure::none;
  if (rollout.arm_error > kArmTrackingTolerance_deg ||
      rollout.hand_error > kHandTrackingTolerance_deg)
    return Failure::tracking_error;
  if (displaced_before) return Failure::displaced_before_closing;
  if (displaced) return Failure::displaced_while_closing;
  return std::isnan(rollout.contact_s) ? Failure::no_touch : Failure::no_opposing_contacts;
}

/// Executes the trajectory and the squeeze. Returns false, with the reason in `lift`, if it failed.
bool execute_grasp(const PreparedPlan& plan, const SimulateOptions& options, Simulation& simulation,
                   Rollout& rollout) {
  std::vector<physics::GeomContact> touches;
  const Pose start = simulation.target();
  bool displaced_before = false;
  for (Eigen::Index row = 0; row < plan.program.grasp_end; ++row) {
    if (const auto problem = simulation.step(row)) {
      rollout.lift = engine_failure(*problem);
      return false;
    }
    if (std::isnan(rollout.contact_s)) {
      if (!target_contacts(simulation.state(), simulation.parts(), touches).empty())
        rollout.contact_s = static_cast<double>(row + 1) * options.step_s;
      else if (row < plan.program.tracking_end)
        update_tracking_error(plan, simulation, row, rollout);
    }
    update_maximum(displacement_between(start, simulation.target()), rollout.pregrasp_displacement);
    if (row + 1 == plan.program.tracking_end)
      displaced_before = rollout.pregrasp_displacement.distance_m > kMaxPregraspDisplacement_m;
  }
  const std::vector<TargetContact> contacts =
      target_contacts(simulation.state(), simulation.parts(), touches);
  rollout.measured_force_N = measured_forces(plan, contacts);
  rollout.lift.failure = grasp_failure(rollout, displaced_before, has_opposing_contacts(contacts));
  return rollout.lift.is_held();
}

HoldResult lift_and_hold(const PreparedPlan& plan, const SimulateOptions& options,
                         Simulation& simulation) {
  HoldMonitor monitor(*plan.robot, simulation.parts(), simulation.state());
  for (Eigen::Index row = plan.program.grasp_end; row < plan.program.hold_end; ++row) {
    if (const auto problem = simulation.step(row)) return engine_failure(*problem);
    if ((row + 1) % kMonitorIntervalSteps != 0 && row + 1 != plan.program.hold_end) continue;
    const double lifted_s = static_cast<double>(row + 1 - plan.program.lift_end) * options.step_s;
    monitor.update(simulation.state(), lifted_s >= kDroopTime_s, simulation.finger_at_limit());
    if (monitor.failed()) break;
  }
  return monitor.result();
}

/// Applies the weight along one direction, ramped over kLoadRampTime_s and then constant.
HoldResult apply_load(const PreparedPlan& plan, const Variation& variation,
                      const SimulateOptions& options, const physics::Snapshot& squeezed,
                      const Vec3& direction, Simulation& simulation) {
  simulation.state().restore(squeezed);
  simulation.state().update_poses();  // the monitor needs poses; they change the warm start
  simulation.state().restore(squeezed);
  HoldMonitor monitor(*plan.robot, simulation.parts(), simulation.state());
  const Vec3 weight =
      variation.mass_kg * kGravity_m_s2 * (variation.base_from_target.linear() * direction);
  const Eigen::Index steps = std::lround(kLoadTime_s / options.step_s);
  for (int k = 0; k < steps; ++k) {
    const double loaded_s = (k + 1) * options.step_s;
    simulation.state().apply_force(simulation.parts().target_body,
                                   std::min(1.0, loaded_s / kLoadRampTime_s) * weight);
    if (const auto problem = simulation.step(plan.program.grasp_end - 1))
      return engine_failure(*problem);
    if ((k + 1) % kMonitorIntervalSteps != 0 && k + 1 != steps) continue;
    monitor.update(simulation.state(), loaded_s >= kLoadRampTime_s + kDroopTime_s,
                   simulation.finger_at_limit());
    if (monitor.failed()) break;
  }
  return monitor.result();
}

std::vector<HoldResult> test_six_directions(const PreparedPlan& plan, const Variation& variation,
                                            const SimulateOptions& options,
                                            const physics::Snapshot& squeezed) {
  std::vector<HoldResult> results;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Simulation simulation(plan, variation, options, Environment::none);
      results.push_back(
          apply_load(plan, variation, options, squeezed, sign * Vec3::Unit(axis), simulation));
    }
  }
  return results;
}

void add_required_forces(const PreparedPlan& plan, Rollout& rollout) {
  const RequiredForces required = required_forces(plan, rollout.variation);
  rollout.commanded_force_N = required.commanded_N;
  rollout.required_force_worst_N = required.worst_N;
  rollout.required_force_gravity_N = required.gravity_N;
  rollout.lift.required_force_N = required.lift_N;
  for (int k = 0; k < std::ssize(rollout.load_directions); ++k)
    rollout.load_directions[k].required_force_N = required.along_axes_N[k];
}

}  // namespace

Rollout roll_out(const PreparedPlan& plan, const Variation& variation,
                 const SimulateOptions& options, bool directions) {
  Rollout rollout;
  rollout.variation = variation;
  rollout.contact_s = kUnknown;
  try {
    Simulation simulation(plan, variation, options, Environment::scene);
    simulation.start();
    const bool holds = execute_grasp(plan, options, simulation, rollout);
    const physics::Snapshot squeezed = simulation.state().snapshot();
    if (holds && plan.task)
      execute_task(plan, options, simulation, rollout);
    else if (holds)
      rollout.lift = lift_and_hold(plan, options, simulation);
    rollout.torque_ratio = simulation.torque_ratio();
    if (holds && directions)
      rollout.load_directions = test_six_directions(plan, variation, options, squeezed);
  } catch (const physics::EngineError& error) {
    rollout.lift = engine_failure(error.what());
  }
  if (plan.task && !rollout.task) rollout.task = TaskResult{rollout.lift.failure};
  add_required_forces(plan, rollout);
  return rollout;
}

}  // namespace morphe::simulate
