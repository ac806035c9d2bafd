#include "stages/simulate/rollout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/physics/state.hpp"
#include "core/robot/tree.hpp"
#include "stages/simulate/lift.hpp"
#include "stages/simulate/newtons.hpp"
#include "stages/simulate/watch.hpp"

namespace morphe::simulate {
namespace {

constexpr Eigen::Index kLook = 5;   ///< steps from one look at the target to the next
constexpr double kAtLimit = 0.999;  ///< of a motor's torque

/// Of a hand's base, as lift() has the palm.
double base_height(const Program& program, Eigen::Index row) {
  const double done = static_cast<double>(row + 1 - program.squeezed) /
                      static_cast<double>(program.lifted - program.squeezed);
  return kLift_m * minimum_jerk(std::clamp(done, 0.0, 1.0));
}

/// A model with its state, moved by rows of a program.
class Simulation {
 public:
  Simulation(const PreparedPlan& plan, const Variation& variation, const SimulateOptions& options,
             Around around)
      : plan_(plan),
        model_(model_text(plan.world, variation, options, around)),
        parts_(model_, *plan.robot, plan.world.lifts_base),
        state_(model_),
        motor_frames_(motor_frames(*plan.robot)) {}

  void start() {
    const RobotTable& robot = *plan_.robot;
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      const RobotTable::Frame& frame = robot.frames[f];
      if (frame.joint >= 0)
        state_.set_joint(parts_.joints[f],
                         frame.ratio * plan_.program.start[frame.joint] + frame.offset);
    }
    state_.pose();
  }

  std::optional<std::string> step(Eigen::Index row) {
    for (std::size_t j = 0; j < parts_.motors.size(); ++j) {
      const RobotTable::Frame& motor = motor_of(j);
      const double q = plan_.program.control(row, static_cast<Eigen::Index>(j));
      state_.set_control(parts_.motors[j], motor.ratio * q + motor.offset);
    }
    carry_acceleration(row);
    if (parts_.base_motor >= 0)
      state_.set_control(parts_.base_motor, base_height(plan_.program, row));
    const std::optional<std::string> wrong = state_.step();
    if (!wrong) note_torques();
    return wrong;
  }

  double position(std::size_t joint) const {
    const RobotTable::Frame& motor = motor_of(joint);
    const int number = parts_.joints[static_cast<std::size_t>(motor_frames_[joint])];
    return (state_.joint(number) - motor.offset) / motor.ratio;
  }

  Pose target() const { return state_.body(parts_.target_body); }
  physics::State& state() { return state_; }
  const Parts& parts() const { return parts_; }
  double torque_share() const { return torque_share_; }
  bool finger_at_limit() const { return finger_at_limit_; }
  const RobotTable::Frame& motor_of(std::size_t joint) const {
    return plan_.robot->frames[static_cast<std::size_t>(motor_frames_[joint])];
  }

 private:
  void carry_acceleration(Eigen::Index row) {
    if (row > plan_.program.followed) return;  // what is set once stays
    const RobotTable& robot = *plan_.robot;
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      const RobotTable::Frame& frame = robot.frames[f];
      if (frame.joint < 0) continue;
      const double joint =
          row < plan_.program.followed ? plan_.program.acceleration(row, frame.joint) : 0;
      state_.set_acceleration(parts_.joints[f], frame.ratio * joint);
    }
  }

  void note_torques() {
    finger_at_limit_ = false;
    for (std::size_t j = 0; j < parts_.motors.size(); ++j) {
      const double limit = plan_.world.servos[j].torque;
      torque_share_ = std::max(torque_share_, std::abs(state_.given(parts_.motors[j])) / limit);
      if (std::ranges::count(plan_.robot->arm_joints, static_cast<int>(j)) > 0) continue;
      finger_at_limit_ =
          finger_at_limit_ || std::abs(state_.asked(parts_.motors[j])) >= kAtLimit * limit;
    }
  }

  const PreparedPlan& plan_;
  physics::Model model_;
  Parts parts_;
  physics::State state_;
  std::vector<int> motor_frames_;
  double torque_share_ = 0;
  bool finger_at_limit_ = false;
};

Holding broken(const std::string& words) {
  Holding holding;
  holding.failure = Failure::engine;
  holding.detail = words;
  return holding;
}

/// Degrees, or mm of a joint that slides.
void note_tracking(const PreparedPlan& plan, const Simulation& simulation, Eigen::Index row,
                   Rollout& rollout) {
  const robot::Robot& robot = *plan.robot;
  for (std::size_t j = 0; j < robot.joints(); ++j) {
    const bool slides = simulation.motor_of(j).slides;
    const double error = std::abs(simulation.position(j) -
                                  plan.program.reference(row, static_cast<Eigen::Index>(j))) *
                         (slides ? 1000 : 1 / kDegree);
    double& largest = std::ranges::count(robot.arm_joints, static_cast<int>(j)) > 0
                          ? rollout.arm_error
                          : rollout.hand_error;
    largest = std::max(largest, error);
  }
}

/// Along the normal, by the last link of each press's finger.
std::vector<double> pressed(const PreparedPlan& plan, const std::vector<Grip>& grips) {
  const RobotTable& robot = *plan.robot;
  std::vector<double> forces;
  for (const Press& press : plan.squeeze.presses) {
    const int link = robot::body_of(robot, robot.tips[press.tip].frame);
    double force = 0;
    for (const Grip& grip : grips) {
      if (robot::body_of(robot, robot.capsules[static_cast<std::size_t>(grip.capsule)].frame) ==
          link)
        force += grip.force_N;
    }
    forces.push_back(force);
  }
  return forces;
}

bool astray(const Rollout& rollout) {
  return rollout.arm_error > kArmAstray || rollout.hand_error > kHandAstray;
}

/// Why the hand has no hold of the target, if it has none.
Failure why_not_taken(const Rollout& rollout, bool knocked, bool opposed) {
  const bool pushed = rollout.pushed.distance_m > kPushed_m;
  if (!pushed && opposed) return Failure::none;
  if (astray(rollout)) return Failure::tracking;
  if (knocked) return Failure::knocked;
  if (pushed) return Failure::pushed;
  return std::isnan(rollout.contact_s) ? Failure::not_touched : Failure::no_contact;
}

/// The trajectory and the squeeze. False: it ends here, and why is in `lift`.
bool take_hold(const PreparedPlan& plan, const SimulateOptions& options, Simulation& simulation,
               Rollout& rollout) {
  std::vector<physics::Touch> touches;
  const Pose placed = simulation.target();
  bool knocked = false;
  for (Eigen::Index row = 0; row < plan.program.squeezed; ++row) {
    if (const auto wrong = simulation.step(row)) {
      rollout.lift = broken(*wrong);
      return false;
    }
    if (std::isnan(rollout.contact_s)) {
      if (!grips_of(simulation.state(), simulation.parts(), touches).empty())
        rollout.contact_s = static_cast<double>(row + 1) * options.step_s;
      else if (row < plan.program.followed)
        note_tracking(plan, simulation, row, rollout);
    }
    const Way way = way_between(placed, simulation.target());
    rollout.pushed.distance_m = std::max(rollout.pushed.distance_m, way.distance_m);
    rollout.pushed.angle_deg = std::max(rollout.pushed.angle_deg, way.angle_deg);
    if (row + 1 == plan.program.followed) knocked = rollout.pushed.distance_m > kPushed_m;
  }
  const std::vector<Grip> grips = grips_of(simulation.state(), simulation.parts(), touches);
  rollout.pressed_N = pressed(plan, grips);
  rollout.lift.failure = why_not_taken(rollout, knocked, opposed(grips));
  return rollout.lift.held();
}

Holding lift_and_hold(const PreparedPlan& plan, const SimulateOptions& options,
                      Simulation& simulation) {
  Watch watch(*plan.robot, simulation.parts(), simulation.state());
  for (Eigen::Index row = plan.program.squeezed; row < plan.program.held; ++row) {
    if (const auto wrong = simulation.step(row)) return broken(*wrong);
    if ((row + 1) % kLook != 0 && row + 1 != plan.program.held) continue;
    const double since_s = static_cast<double>(row + 1 - plan.program.lifted) * options.step_s;
    watch.look(simulation.state(), since_s >= kSagTime_s, simulation.finger_at_limit());
    if (watch.failed()) break;
  }
  return watch.verdict();
}

/// The weight comes from one direction, in kRamp_s, and stays.
Holding load(const PreparedPlan& plan, const Variation& variation, const SimulateOptions& options,
             const physics::Snapshot& squeezed, const Vec3& direction, Simulation& simulation) {
  simulation.state().restore(squeezed);
  simulation.state().pose();
  simulation.state().restore(squeezed);
  Watch watch(*plan.robot, simulation.parts(), simulation.state());
  const Vec3 weight =
      variation.mass_kg * kGravity * (variation.base_from_target.linear() * direction);
  const auto steps = static_cast<Eigen::Index>(std::llround(kLoad_s / options.step_s));
  for (Eigen::Index k = 0; k < steps; ++k) {
    const double at_s = static_cast<double>(k + 1) * options.step_s;
    simulation.state().push(simulation.parts().target_body, std::min(1.0, at_s / kRamp_s) * weight);
    if (const auto wrong = simulation.step(plan.program.squeezed - 1)) return broken(*wrong);
    if ((k + 1) % kLook != 0 && k + 1 != steps) continue;
    watch.look(simulation.state(), at_s >= kRamp_s + kSagTime_s, simulation.finger_at_limit());
    if (watch.failed()) break;
  }
  return watch.verdict();
}

std::vector<Holding> six_directions(const PreparedPlan& plan, const Variation& variation,
                                    const SimulateOptions& options,
                                    const physics::Snapshot& squeezed) {
  std::vector<Holding> holdings;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Simulation simulation(plan, variation, options, Around::nothing);
      holdings.push_back(
          load(plan, variation, options, squeezed, sign * Vec3::Unit(axis), simulation));
    }
  }
  return holdings;
}

void foretell(const PreparedPlan& plan, Rollout& rollout) {
  const Newtons newtons = newtons_of(plan, rollout.variation);
  rollout.given_N = newtons.given;
  rollout.needed_worst_N = newtons.worst;
  rollout.needed_down_N = newtons.down;
  rollout.lift.needed_N = newtons.lift;
  for (std::size_t k = 0; k < rollout.directions.size(); ++k)
    rollout.directions[k].needed_N = newtons.along[k];
}

}  // namespace

Rollout roll_out(const PreparedPlan& plan, const Variation& variation,
                 const SimulateOptions& options, bool directions) {
  Rollout rollout;
  rollout.variation = variation;
  rollout.contact_s = kNotSeen;
  try {
    Simulation simulation(plan, variation, options, Around::world);
    simulation.start();
    const bool holds = take_hold(plan, options, simulation, rollout);
    const physics::Snapshot squeezed = simulation.state().snapshot();
    if (holds) rollout.lift = lift_and_hold(plan, options, simulation);
    rollout.torque_share = simulation.torque_share();
    if (holds && directions)
      rollout.directions = six_directions(plan, variation, options, squeezed);
  } catch (const physics::EngineError& error) {
    rollout.lift = broken(error.what());
  }
  foretell(plan, rollout);
  return rollout;
}

}  // namespace morphe::simulate
