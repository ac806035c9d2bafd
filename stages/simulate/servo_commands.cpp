#include "stages/simulate/servo_commands.hpp"

#include <algorithm>
#include <cmath>

#include "stages/simulate/options.hpp"
#include "stages/simulate/plan_lift.hpp"
#include "stages/simulate/trajectory_curve.hpp"
#include "stages/simulate/written_clock.hpp"

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
/// Returns the progress of a part of `steps` steps that begins at step `from`, after step `row`.
double progress_after(Eigen::Index row, Eigen::Index from, Eigen::Index steps) {
  const double s = static_cast<double>(row + 1 - from) / static_cast<double>(steps);
  return minimum_jerk(std::clamp(s, 0.0, 1.0));
}

/// Appends the parts of a program one after the other.
class CommandWriter {
 public:
  CommandWriter(const Plan& plan, Eigen::Index last_sample, const std::vector<Servo>& servos,
                const GraspCommand& squeeze, double step_s)
      : servos_(servos),
        squeeze_(squeeze),
        step_s_(step_s),
        curve_(plan.trajectory, last_sample),
        open_(plan.trajectory.position.row(last_tracked_sample(plan)).transpose()) {
    program_.start = plan.trajectory.position.row(0).transpose();
  }

  /// Follows the trajectory, with `offset` added to the servo targets. Targets are for the begin of
  /// a step, references for its end.
  void follow(const WrittenClock& clock, const JointVector& offset) {
    const Eigen::Index from = begin_part(steps_in(clock.duration_s(), step_s_));
    for (Eigen::Index row = from; row < steps(); ++row) {
      const ClockReading now = clock.at(static_cast<double>(row - from) * step_s_);
      curve_.move_to(now.time_s);
      const JointVector velocity = curve_.derivative(1);
      program_.control.row(row) =
          (with_velocity_lead(curve_.derivative(0), now.rate * velocity, servos_) + offset)
              .transpose();
      program_.acceleration.row(row) =
          (now.rate * now.rate * curve_.derivative(2) + now.rate_slope * velocity).transpose();
      const double after_s = std::min(static_cast<double>(row + 1 - from) * step_s_,
                                      std::max(clock.duration_s(), 0.0));
      program_.trajectory_s.push_back(clock.at(after_s).time_s);
      curve_.move_to(program_.trajectory_s.back());
      program_.reference.row(row) = curve_.derivative(0).transpose();
    }
  }

  /// Closes the fingers, squeezes and settles while the arm stays.
  void grasp() {
    const Eigen::Index closing = steps_in(kClosingTime_s, step_s_);
    const Eigen::Index pressing = steps_in(kForceRampTime_s, step_s_);
    const Eigen::Index from = begin_part(closing + pressing + steps_in(kSettle_s, step_s_));
    for (Eigen::Index row = from; row < steps(); ++row) {
      program_.control.row(row) =
          (open_ + progress_after(row, from, closing) * (squeeze_.closed_posture - open_) +
           progress_after(row, from + closing, pressing) * squeeze_.servo_offset)
              .transpose();
      program_.reference.row(row) = open_.transpose();
    }
  }

  /// Follows one row per step, and then stays for hold_steps.
  void lift(const JointRows& lifting) {
    JointVector previous = squeeze_.closed_posture;
    const Eigen::Index from = begin_part(lifting.rows());
    for (Eigen::Index row = 0; row < lifting.rows(); ++row) {
      const JointVector q = lifting.row(row).transpose();
      program_.control.row(from + row) =
          (with_velocity_lead(q, (q - previous) / step_s_, servos_) + squeeze_.servo_offset)
              .transpose();
      program_.reference.row(from + row) = q.transpose();
      previous = q;
    }
    lifted_ = previous;
  }

  void hold(double duration_s) {
    stay(lifted_ + squeeze_.servo_offset, steps_in(duration_s, step_s_));
  }

  /// Takes `offset` from the servo targets while the arm stays, and settles.
  void let_go(const JointVector& offset) {
    const JointVector posture = curve_.derivative(0);
    const Eigen::Index fading = steps_in(kForceRampTime_s, step_s_);
    const Eigen::Index from = begin_part(fading + steps_in(kSettle_s, step_s_));
    for (Eigen::Index row = from; row < steps(); ++row) {
      program_.control.row(row) =
          (posture + (1 - progress_after(row, from, fading)) * offset).transpose();
      program_.reference.row(row) = posture.transpose();
    }
  }

  void stand(double duration_s) { stay(curve_.derivative(0), steps_in(duration_s, step_s_)); }

  /// Returns the offset of the servo targets while the fingers squeeze.
  JointVector squeezing_offset() const {
    return squeeze_.closed_posture - open_ + squeeze_.servo_offset;
  }
  Eigen::Index steps() const { return program_.control.rows(); }
  ServoCommands& program() { return program_; }

 private:
  /// Appends rows; returns the first one. Accelerations are 0 until they are set.
  Eigen::Index begin_part(Eigen::Index added) {
    const Eigen::Index from = steps(), n = open_.size();
    for (JointRows* rows : {&program_.control, &program_.reference, &program_.acceleration})
      rows->conservativeResize(from + added, n);
    program_.acceleration.bottomRows(added).setZero();
    return from;
  }
  void stay(const JointVector& target, Eigen::Index added) {
    begin_part(added);
    program_.control.bottomRows(added).rowwise() = target.transpose();
    program_.reference.bottomRows(added).rowwise() = target.transpose();
  }

  const std::vector<Servo>& servos_;
  const GraspCommand& squeeze_;
  const double step_s_;
  TrajectoryCurve curve_;
  JointVector open_, lifted_;
  ServoCommands program_;
};

double since_start_s(const Trajectory& trajectory, Eigen::Index sample) {
  return trajectory.time[sample] - trajectory.time.front();
}

}  // namespace

Eigen::Index last_tracked_sample(const Plan& plan) {
  const std::vector<PhaseKind>& phase = plan.trajectory.phase;
  Eigen::Index last = plan.grasp.sample;
  while (last + 1 < std::ssize(plan.trajectory.time) && phase[last + 1] == PhaseKind::grasp) ++last;
  return last;
}

ServoCommands lift_commands(const Plan& plan, const std::vector<Servo>& servos,
                            const GraspCommand& squeeze, const JointRows& lifting, double step_s) {
  const Eigen::Index last = last_tracked_sample(plan);
  CommandWriter writer(plan, last, servos, squeeze, step_s);
  ServoCommands& program = writer.program();
  const JointVector no_offset = JointVector::Zero(plan.trajectory.position.cols());
  writer.follow({0, since_start_s(plan.trajectory, last), false, false}, no_offset);
  program.tracking_end = writer.steps();
  writer.grasp();
  program.grasp_end = writer.steps();
  writer.lift(lifting);
  program.lift_end = writer.steps();
  writer.hold(kHold_s);
  program.hold_end = writer.steps();
  return program;
}

ServoCommands task_commands(const Plan& plan, const PlannedTask& task,
                            const std::vector<Servo>& servos, const GraspCommand& squeeze,
                            double step_s) {
  const Trajectory& t = plan.trajectory;
  const double grasp_s = since_start_s(t, last_tracked_sample(plan));
  CommandWriter writer(plan, std::ssize(t.time) - 1, servos, squeeze, step_s);
  ServoCommands& program = writer.program();
  writer.follow({0, grasp_s, false, true}, JointVector::Zero(t.position.cols()));
  program.tracking_end = writer.steps();
  writer.grasp();
  program.grasp_end = writer.steps();
  writer.follow({grasp_s, task.release_s, true, true}, writer.squeezing_offset());
  program.carry_end = program.release_end = program.leave_end = program.stand_end = writer.steps();
  if (!task.lets_go) return program;
  writer.let_go(writer.squeezing_offset());
  program.release_end = writer.steps();
  writer.follow({task.release_s, since_start_s(t, std::ssize(t.time) - 1), true, false},
                JointVector::Zero(t.position.cols()));
  program.leave_end = writer.steps();
  writer.stand(kStandTime_s);
  program.stand_end = writer.steps();
  return program;
}

}  // namespace morphe::simulate
