#include "stages/retime/paced_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/braking.hpp"
#include "core/robot/forward.hpp"

namespace morphe::retime {
namespace {

/// Speed of the fastest tip per du/dt [m].
double tip_rate(const RobotTable& robot, const JointRows& q) {
  std::vector<Pose> base_from_frame;
  const JointVector position = q.row(0).transpose(), rate = q.row(1).transpose();
  robot::forward(robot, position, base_from_frame);
  Eigen::Matrix3Xd jacobian(3, position.size());
  double fastest = 0;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
    robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
    fastest = std::max(fastest, (jacobian * rate).norm());
  }
  return fastest;
}

/// Least s per clock second that the braking curves leave.
double braking_rate(const PacedPath& paced_path, const JointRows& q) {
  constexpr double kLeastLeft = 1e-3;  ///< of the velocity limit: the pace stays above 0
  double slowest = 0;
  for (const RobotTable::BrakingCurve& curve : paced_path.robot->braking_curves) {
    const double rate = q(1, curve.joint);
    const double left =
        paced_path.braking_share * math::speed_left(curve, q(0, curve.joint), rate > 0);
    const double least = kLeastLeft * paced_path.velocity[curve.joint];
    slowest = std::max(slowest, std::abs(rate) / std::max(left, least));
  }
  return slowest;
}

/// Of values over equal cells, at a share of their length; `otherwise` if there are none.
double of_cell(const std::vector<double>& values, double share, double otherwise) {
  if (values.empty()) return otherwise;
  const auto cells = static_cast<double>(values.size());
  return values[static_cast<std::size_t>(std::clamp(share * cells, 0.0, cells - 1))];
}

}  // namespace

double slowdown_at(const PacedPath& paced_path, double u) {
  return of_cell(paced_path.slowdown, u / paced_path.spline.length, 1);
}

double most_pace(const PacedPath& paced_path, double u, const JointRows& q) {
  double least_s = (q.row(1).transpose().cwiseAbs().cwiseQuotient(paced_path.velocity)).maxCoeff();
  least_s = std::max(least_s, braking_rate(paced_path, q)) * slowdown_at(paced_path, u);
  if (paced_path.tip_speed < kMostPace) {
    least_s = std::max(least_s, tip_rate(*paced_path.robot, q) / paced_path.tip_speed);
  }
  const double z = std::min(1.0, std::min(u, paced_path.spline.length - u) / paced_path.catch_up_s);
  const double hurry = of_cell(paced_path.hurry, u / paced_path.spline.length, 0);
  const double tempo =
      paced_path.tempo * (1 + hurry) * (1 + paced_path.catch_up * (1 - z * z * (3 - 2 * z)));
  const double pace = std::min(1 / std::max(least_s, 1 / kMostPace), tempo);
  if (paced_path.phase_scale.empty()) return pace;
  const PhaseKind phase =
      phase_at(paced_path.movement->phases, demonstration_time_at(paced_path.clocked, u));
  return pace * paced_path.phase_scale[static_cast<std::size_t>(phase)];
}

PaceGrid pace_grid(const PacedPath& paced_path, Eigen::Index steps) {
  PaceGrid grid;
  grid.step = paced_path.spline.length / static_cast<double>(steps);
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
    const double pace = most_pace(paced_path, u, q);
    grid.ceiling[i] = pace * pace;
  }
  return grid;
}

}  // namespace morphe::retime
