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
JointVector with_velocity_lead(const JointVector& position, const JointVector& velocity,
                               const std::vector<Servo>& servos) {
  JointVector target = position;
  for (int j = 0; j < target.size(); ++j) target[j] += servos[j].lead_s * velocity[j];
  return target;
}

/// Evaluates the quintics of the planned trajectory; the time must not decrease between calls.
class Curve {
 public:
  Curve(const Trajectory& trajectory, Eigen::Index last) : trajectory_(trajectory), last_(last) {}

  void move_to(double since_start_s) {
    const std::vector<double>& time = trajectory_.time;
    const double time_s = std::min(time.front() + since_start_s, time[last_]);
    while (sample_ + 2 <= last_ && time[sample_ + 1] <= time_s) ++sample_;
    since_sample_s_ = time_s - time[sample_];
  }
  JointVector derivative(int order) const {
    JointVector out(trajectory_.position.cols());
    for (int j = 0; j < out.size(); ++j)
      out[j] = math::value_at(math::quintic_piece(trajectory_, sample_, j), since_sample_s_, order);
    return out;
  }

 private:
  const Trajectory& trajectory_;
  Eigen::Index last_, sample_ = 0;
  double since_sample_s_ = 0;
};

/// Fills the commands of the trajectory: targets for the beginning of a step, references for its
/// end.
void fill_tracking_commands(const Trajectory& trajectory, Eigen::Index last,
                            const std::vector<Servo>& servos, double step_s,
                            ServoCommands& program) {
  Curve curve(trajectory, last);
  for (int row = 0; row < program.tracking_end; ++row) {
    curve.move_to(row * step_s);
    program.control.row(row) =
        with_velocity_lead(curve.derivative(0), curve.derivative(1), servos).transpose();
    program.acceleration.row(row) = curve.derivative(2).transpose();
    curve.move_to((row + 1) * step_s);
    program.reference.row(row) = curve.derivative(0).transpose();
  }
}

}  // namespace

Eigen::Index last_tracked_sample(const Plan& plan) {
  const std::vector<PhaseKind>& phase = plan.trajectory.phase;
  Eigen::Index last = plan.grasp.sample;
  while (last + 1 < std::ssize(plan.trajectory.time) && phase[last + 1] == PhaseKind::grasp) ++last;
  return last;
}

ServoCommands make_servo_commands(const robot::Robot& robot, const Plan& plan,
                                  const std::vector<Servo>& servos, const GraspCommand& squeeze,
                                  const JointRows& lifting, double step_s) {
  const Trajectory& t = plan.trajectory;
  const Eigen::Index last = last_tracked_sample(plan), n = robot.joints();
  ServoCommands program;
  program.start = t.position.row(0).transpose();
  program.tracking_end = steps_in(t.time[last] - t.time.front(), step_s);
  const Eigen::Index closing = steps_in(kClosingTime_s, step_s);
  const Eigen::Index pressing = steps_in(kForceRampTime_s, step_s);
  program.grasp_end = program.tracking_end + closing + pressing + steps_in(kSettle_s, step_s);
  program.lift_end = program.grasp_end + lifting.rows();
  program.hold_end = program.lift_end + steps_in(kHold_s, step_s);
  program.control.resize(program.hold_end, n);
  program.reference.resize(program.tracking_end, n);
  program.acceleration.resize(program.tracking_end, n);
  fill_tracking_commands(t, last, servos, step_s, program);

  const JointVector open = t.position.row(last).transpose();
  for (Eigen::Index row = program.tracking_end; row < program.grasp_end; ++row) {
    const auto progress = [&](Eigen::Index from, Eigen::Index steps) {
      const double s = static_cast<double>(row + 1 - from) / static_cast<double>(steps);
      return minimum_jerk(std::clamp(s, 0.0, 1.0));
    };
    program.control.row(row) =
        (open + progress(program.tracking_end, closing) * (squeeze.closed_posture - open) +
         progress(program.tracking_end + closing, pressing) * squeeze.servo_offset)
            .transpose();
  }
  JointVector previous = squeeze.closed_posture;
  for (Eigen::Index row = 0; row < lifting.rows(); ++row) {
    const JointVector q = lifting.row(row).transpose();
    program.control.row(program.grasp_end + row) =
        (with_velocity_lead(q, (q - previous) / step_s, servos) + squeeze.servo_offset).transpose();
    previous = q;
  }
  const JointVector end =
      lifting.rows() > 0 ? JointVector(lifting.bottomRows(1).transpose()) : squeeze.closed_posture;
  program.control.bottomRows(program.hold_end - program.lift_end).rowwise() =
      (end + squeeze.servo_offset).transpose();
  return program;
}

}  // namespace morphe::simulate
