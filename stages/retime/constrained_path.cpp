#include "stages/retime/constrained_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/braking.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::retime {
namespace {

/// Returns the speed of the fastest tip per du/dt [m].
double tip_rate(const RobotModel& robot, const JointRows& q) {
  std::vector<Pose> base_from_frame;
  const JointVector position = q.row(0).transpose(), rate = q.row(1).transpose();
  robot::forward_kinematics(robot, position, base_from_frame);
  Eigen::Matrix3Xd jacobian(3, position.size());
  double fastest = 0;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
    robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
    fastest = std::max(fastest, (jacobian * rate).norm());
  }
  return fastest;
}

/// Returns the least time per unit of path parameter that the braking curves allow [s/s].
double braking_rate(const ConstrainedPath& paced_path, const JointRows& q) {
  /// share of the velocity limit; keeps the path velocity above 0
  constexpr double kMinBrakingVelocityRatio = 1e-3;
  double slowest = 0;
  for (const RobotModel::BrakingCurve& curve : paced_path.robot->braking_curves) {
    const double rate = q(1, curve.joint);
    const double left =
        paced_path.braking_share * math::braking_speed_limit(curve, q(0, curve.joint), rate > 0);
    const double least = kMinBrakingVelocityRatio * paced_path.velocity[curve.joint];
    slowest = std::max(slowest, std::abs(rate) / std::max(left, least));
  }
  return slowest;
}

/// Returns the value of the cell at a share of the length, from values over equal cells;
/// `otherwise` if there are no values.
double of_cell(const std::vector<double>& values, double share, double otherwise) {
  if (values.empty()) return otherwise;
  const auto cells = static_cast<double>(values.size());
  return values[static_cast<std::size_t>(std::clamp(share * cells, 0.0, cells - 1))];
}

}  // namespace

double slowdown_at(const ConstrainedPath& paced_path, double u) {
  return of_cell(paced_path.slowdown, u / paced_path.spline.duration_s, 1);
}

double max_path_velocity(const ConstrainedPath& paced_path, double u, const JointRows& q) {
  double least_s = (q.row(1).transpose().cwiseAbs().cwiseQuotient(paced_path.velocity)).maxCoeff();
  least_s = std::max(least_s, braking_rate(paced_path, q)) * slowdown_at(paced_path, u);
  if (paced_path.tip_speed < kMaxPathVelocity) {
    least_s = std::max(least_s, tip_rate(*paced_path.robot, q) / paced_path.tip_speed);
  }
  const double z =
      std::min(1.0, std::min(u, paced_path.spline.duration_s - u) / paced_path.end_speedup_s);
  const double hurry = of_cell(paced_path.speedup, u / paced_path.spline.duration_s, 0);
  const double tempo = paced_path.nominal_path_velocity * (1 + hurry) *
                       (1 + paced_path.end_speedup * (1 - z * z * (3 - 2 * z)));
  const double pace = std::min(1 / std::max(least_s, 1 / kMaxPathVelocity), tempo);
  if (paced_path.phase_scale.empty()) return pace;
  const PhaseKind phase =
      phase_at(paced_path.movement->phases, demonstration_time_at(paced_path.parameterized, u));
  return pace * paced_path.phase_scale[static_cast<std::size_t>(phase)];
}

PathGrid path_grid(const ConstrainedPath& paced_path, Eigen::Index steps) {
  PathGrid grid;
  grid.step = paced_path.spline.duration_s / static_cast<double>(steps);
  const Eigen::Index n = paced_path.acceleration.size();
  const Eigen::ArrayXd inverse = paced_path.acceleration.array().inverse();
  grid.first.resize(n, steps + 1);
  grid.second.resize(n, steps + 1);
  grid.ceiling.resize(steps + 1);
  JointRows q;
  for (Eigen::Index i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) * grid.step;
    math::evaluate(paced_path.spline, u, q);
    const double slower = slowdown_at(paced_path, u) * slowdown_at(paced_path, u);
    grid.first.col(i) = slower * q.row(1).transpose().array() * inverse;
    grid.second.col(i) = slower * q.row(2).transpose().array() * inverse;
    const double pace = max_path_velocity(paced_path, u, q);
    grid.ceiling[i] = pace * pace;
  }
  return grid;
}

}  // namespace morphe::retime
