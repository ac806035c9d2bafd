#include "stages/retime/constrained_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/braking.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::retime {
namespace {
double tip_rate(const RobotModel& robot, const JointRows& q) {
  std::vector<Pose> base_from_frame;
  const JointVector position = q.row(0).transpose(), rate = q.row(1).transpose();
  robot::forward_kinematics(robot, position, base_from_frame);
  Eigen::Matrix3Xd jacobian(3, position.size());
  double max_speed = 0;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
    robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
    max_speed = std::max(max_speed, (jacobian * rate).norm());
  }
  return max_speed;
}

/// Returns the shortest time per unit of path parameter that the braking curves allow [s/s].
double braking_rate(const ConstrainedPath& path, const JointRows& q) {
  double min_time_s = 0;
  for (const RobotModel::BrakingCurve& curve : path.robot->braking_curves) {
    const double rate = q(1, curve.joint);
    const double speed =
        path.braking_share * math::braking_speed_limit(curve, q(0, curve.joint), rate > 0);
    const double min_speed = kMinBrakingSpeedRatio * path.velocity[curve.joint];
    min_time_s = std::max(min_time_s, std::abs(rate) / std::max(speed, min_speed));
  }
  return min_time_s;
}

/// Returns the value of the cell at a share of the length, which the cells divide equally.
double cell_value(const std::vector<double>& values, double share, double value_if_empty) {
  if (values.empty()) return value_if_empty;
  const auto cells = static_cast<double>(values.size());
  return values[static_cast<std::size_t>(std::clamp(share * cells, 0.0, cells - 1))];
}

}  // namespace

double slowdown_at(const ConstrainedPath& path, double u) {
  return cell_value(path.slowdown, u / path.spline.duration_s, 1);
}

double max_path_velocity(const ConstrainedPath& path, double u, const JointRows& q) {
  double least_s = (q.row(1).transpose().cwiseAbs().cwiseQuotient(path.velocity)).maxCoeff();
  least_s = std::max(least_s, braking_rate(path, q)) * slowdown_at(path, u);
  if (path.tip_speed < kMaxPathVelocity)
    least_s = std::max(least_s, tip_rate(*path.robot, q) / path.tip_speed);
  const double z = std::min(1.0, std::min(u, path.spline.duration_s - u) / path.end_speedup_s);
  const double speedup = cell_value(path.speedup, u / path.spline.duration_s, 0);
  const double nominal = path.nominal_path_velocity * (1 + speedup) *
                         (1 + path.end_speedup * (1 - z * z * (3 - 2 * z)));
  const double velocity = std::min(1 / std::max(least_s, 1 / kMaxPathVelocity), nominal);
  if (path.phase_scale.empty()) return velocity;
  const double time_s = demonstration_time_at(path.parameterized, u);
  auto scale = path.phase_scale.find(phase_at(path.movement->phases, time_s));
  if (scale == path.phase_scale.end())
    scale = path.phase_scale.find(main_phase_at(path.movement->phases, time_s));
  return scale == path.phase_scale.end() ? velocity : velocity * scale->second;
}

PathGrid path_grid(const ConstrainedPath& path, Eigen::Index steps) {
  PathGrid grid;
  grid.step = path.spline.duration_s / static_cast<double>(steps);
  const Eigen::Index n = path.acceleration.size();
  const Eigen::ArrayXd inverse = path.acceleration.array().inverse();
  grid.first.resize(n, steps + 1);
  grid.second.resize(n, steps + 1);
  grid.ceiling.resize(steps + 1);
  JointRows q;
  for (Eigen::Index i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) * grid.step;
    math::evaluate(path.spline, u, q);
    const double squared_slowdown = slowdown_at(path, u) * slowdown_at(path, u);
    grid.first.col(i) = squared_slowdown * q.row(1).transpose().array() * inverse;
    grid.second.col(i) = squared_slowdown * q.row(2).transpose().array() * inverse;
    const double velocity = max_path_velocity(path, u, q);
    grid.ceiling[i] = velocity * velocity;
  }
  return grid;
}

}  // namespace morphe::retime
