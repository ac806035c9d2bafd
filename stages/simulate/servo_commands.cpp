#include "stages/simulate/servo_commands.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quintic.hpp"
#include "stages/simulate/options.hpp"
#include "stages/simulate/plan_lift.hpp"

namespace morphe::simulate {
namespace {

Eigen::Index steps_in(double duration_s, double step_s) {
  return static_cast<Eigen::Index>(std::ceil(duration_s / step_s - 1e-9));
}

/// Returns targets that are advanced by the lag of the servos.
JointVector with_velocity_lead(const JointVector& position, const JointVector& velocity,
                               const std::vector<Servo>& servos) {
  JointVector target = position;
  for (Eigen::Index j = 0; j < target.size(); ++j) target[j] += servos[j].lead_s * velocity[j];
  return target;
}

/// Evaluates the quintics of the planned trajectory; the time must not decrease between calls.
class Curve {
 public:
  Curve(const Trajectory& trajectory, std::size_t last) : t_(trajectory), last_(last) {}

  void move_to(double since_s) {
    at_s_ = std::min(t_.time.front() + since_s, t_.time[last_]);
    while (sample_ + 2 <= last_ && t_.time[sample_ + 1] <= at_s_) ++sample_;
  }
  JointVector derivative(int order) const {
    JointVector values(t_.position.cols());
    for (Eigen::Index j = 0; j < values.size(); ++j)
      values[j] =
          math::value_at(math::quintic_piece(t_, sample_, j), at_s_ - t_.time[sample_], order);
    return values;
  }

 private:
  const Trajectory& t_;
  std::size_t last_, sample_ = 0;
  double at_s_ = 0;
};

/// Fills the commands of the trajectory. A controller sends the target at the begin of a step, and
/// is judged by the robot's position at its end.
void fill_tracking_commands(const Trajectory& t, std::size_t last, const std::vector<Servo>& servos,
                            double step_s, ServoCommands& program) {
  Curve curve(t, last);
  for (Eigen::Index row = 0; row < program.tracking_end; ++row) {
    curve.move_to(static_cast<double>(row) * step_s);
    program.control.row(row) =
        with_velocity_lead(curve.derivative(0), curve.derivative(1), servos).transpose();
    program.acceleration.row(row) = curve.derivative(2).transpose();
    curve.move_to(static_cast<double>(row + 1) * step_s);
    program.reference.row(row) = curve.derivative(0).transpose();
  }
}

}  // namespace

std::size_t last_tracked_sample(const Plan& plan) {
  const Trajectory& t = plan.trajectory;
  std::size_t last = plan.grasp.sample;
  while (last + 1 < t.samples() && t.phase[last + 1] == PhaseKind::grasp) ++last;
  return last;
}

ServoCommands make_servo_commands(const robot::Robot& robot, const Plan& plan,
                                  const std::vector<Servo>& servos, const GraspCommand& squeeze,
                                  const JointRows& lifting, double step_s) {
  const Trajectory& t = plan.trajectory;
  const std::size_t last = last_tracked_sample(plan);
  const auto n = static_cast<Eigen::Index>(robot.joints());
  ServoCommands program;
  program.start = t.position.row(0).transpose();
  program.tracking_end = steps_in(t.time[last] - t.time.front(), step_s);
  const Eigen::Index closing = steps_in(kClosingTime_s, step_s),
                     pressing = steps_in(kForceRampTime_s, step_s);
  program.grasp_end = program.tracking_end + closing + pressing + steps_in(kSettle_s, step_s);
  program.lift_end = program.grasp_end + lifting.rows();
  program.hold_end = program.lift_end + steps_in(kHold_s, step_s);
  program.control.resize(program.hold_end, n);
  program.reference.resize(program.tracking_end, n);
  program.acceleration.resize(program.tracking_end, n);
  fill_tracking_commands(t, last, servos, step_s, program);

  const JointVector open = t.position.row(last).transpose();
  for (Eigen::Index row = program.tracking_end; row < program.grasp_end; ++row) {
    const auto share = [&](Eigen::Index from, Eigen::Index steps) {
      const double s = static_cast<double>(row + 1 - from) / static_cast<double>(steps);
      return minimum_jerk(std::clamp(s, 0.0, 1.0));
    };
    program.control.row(row) =
        (open + share(program.tracking_end, closing) * (squeeze.closed_posture - open) +
         share(program.tracking_end + closing, pressing) * squeeze.servo_offset)
            .transpose();
  }
  JointVector before = squeeze.closed_posture;
  for (Eigen::Index row = 0; row < lifting.rows(); ++row) {
    const JointVector at = lifting.row(row).transpose();
    program.control.row(program.grasp_end + row) =
        (with_velocity_lead(at, (at - before) / step_s, servos) + squeeze.servo_offset).transpose();
    before = at;
  }
  const JointVector end =
      lifting.rows() > 0 ? JointVector(lifting.bottomRows(1).transpose()) : squeeze.closed_posture;
  program.control.bottomRows(program.hold_end - program.lift_end).rowwise() =
      (end + squeeze.servo_offset).transpose();
  return program;
}

}  // namespace morphe::simulate
