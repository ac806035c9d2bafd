#include "stages/simulate/program.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quintic.hpp"
#include "stages/simulate/lift.hpp"
#include "stages/simulate/options.hpp"

namespace morphe::simulate {
namespace {

Eigen::Index steps_in(double duration_s, double step_s) {
  return static_cast<Eigen::Index>(std::ceil(duration_s / step_s - 1e-9));
}

/// Targets that are led by what the servos lag behind.
JointVector led(const JointVector& position, const JointVector& velocity,
                const std::vector<Servo>& servos) {
  JointVector target = position;
  for (Eigen::Index j = 0; j < target.size(); ++j)
    target[j] += servos[static_cast<std::size_t>(j)].lead_s * velocity[j];
  return target;
}

/// The written trajectory's quintics at a time, which must not go back from call to call.
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

/// A controller sends what is wanted as a step begins, and is judged by where the robot is as it
/// ends.
void follow(const Trajectory& t, std::size_t last, const std::vector<Servo>& servos, double step_s,
            Program& program) {
  Curve curve(t, last);
  for (Eigen::Index row = 0; row < program.followed; ++row) {
    curve.move_to(static_cast<double>(row) * step_s);
    program.control.row(row) = led(curve.derivative(0), curve.derivative(1), servos).transpose();
    program.acceleration.row(row) = curve.derivative(2).transpose();
    curve.move_to(static_cast<double>(row + 1) * step_s);
    program.reference.row(row) = curve.derivative(0).transpose();
  }
}

}  // namespace

std::size_t last_followed(const Plan& plan) {
  const Trajectory& t = plan.trajectory;
  std::size_t last = static_cast<std::size_t>(plan.grasp.sample);
  while (last + 1 < t.samples() && t.phase[last + 1] == PhaseKind::grasp) ++last;
  return last;
}

Program program_of(const robot::Robot& robot, const Plan& plan, const std::vector<Servo>& servos,
                   const Squeeze& squeeze, const JointRows& lifting, double step_s) {
  const Trajectory& t = plan.trajectory;
  const std::size_t last = last_followed(plan);
  const auto n = static_cast<Eigen::Index>(robot.joints());
  Program program;
  program.start = t.position.row(0).transpose();
  program.followed = steps_in(t.time[last] - t.time.front(), step_s);
  const Eigen::Index closing = steps_in(kClose_s, step_s), pressing = steps_in(kSqueeze_s, step_s);
  program.squeezed = program.followed + closing + pressing + steps_in(kSettle_s, step_s);
  program.lifted = program.squeezed + lifting.rows();
  program.held = program.lifted + steps_in(kHold_s, step_s);
  program.control.resize(program.held, n);
  program.reference.resize(program.followed, n);
  program.acceleration.resize(program.followed, n);
  follow(t, last, servos, step_s, program);

  const JointVector open = t.position.row(static_cast<Eigen::Index>(last)).transpose();
  for (Eigen::Index row = program.followed; row < program.squeezed; ++row) {
    const auto share = [&](Eigen::Index from, Eigen::Index steps) {
      const double s = static_cast<double>(row + 1 - from) / static_cast<double>(steps);
      return minimum_jerk(std::clamp(s, 0.0, 1.0));
    };
    program.control.row(row) = (open + share(program.followed, closing) * (squeeze.closed - open) +
                                share(program.followed + closing, pressing) * squeeze.beyond)
                                   .transpose();
  }
  JointVector before = squeeze.closed;
  for (Eigen::Index row = 0; row < lifting.rows(); ++row) {
    const JointVector at = lifting.row(row).transpose();
    program.control.row(program.squeezed + row) =
        (led(at, (at - before) / step_s, servos) + squeeze.beyond).transpose();
    before = at;
  }
  const JointVector end =
      lifting.rows() > 0 ? JointVector(lifting.bottomRows(1).transpose()) : squeeze.closed;
  program.control.bottomRows(program.held - program.lifted).rowwise() =
      (end + squeeze.beyond).transpose();
  return program;
}

}  // namespace morphe::simulate
