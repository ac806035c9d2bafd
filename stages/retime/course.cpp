#include "stages/retime/course.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/robot/forward.hpp"

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

}  // namespace

double slowdown_at(const Course& course, double u) {
  if (course.slowdown.empty()) return 1;
  const auto cells = static_cast<double>(course.slowdown.size());
  const double cell = std::clamp(u / course.spline.length * cells, 0.0, cells - 1);
  return course.slowdown[static_cast<std::size_t>(cell)];
}

double most_pace(const Course& course, double u, const JointRows& q) {
  double least_s = (q.row(1).transpose().cwiseAbs().cwiseQuotient(course.velocity)).maxCoeff() *
                   slowdown_at(course, u);
  if (course.tip_speed < kMostPace) {
    least_s = std::max(least_s, tip_rate(*course.robot, q) / course.tip_speed);
  }
  const double z = std::min(1.0, std::min(u, course.spline.length - u) / course.catch_up_s);
  const double tempo = course.tempo * (1 + course.catch_up * (1 - z * z * (3 - 2 * z)));
  const double pace = std::min(1 / std::max(least_s, 1 / kMostPace), tempo);
  if (course.phase_scale.empty()) return pace;
  const PhaseKind phase =
      phase_at(course.movement->phases, demonstration_time_at(course.clocked, u));
  return pace * course.phase_scale[static_cast<std::size_t>(phase)];
}

PaceGrid pace_grid(const Course& course, Eigen::Index steps) {
  PaceGrid grid;
  grid.step = course.spline.length / static_cast<double>(steps);
  const Eigen::Index n = course.acceleration.size();
  const Eigen::ArrayXd inverse = course.acceleration.array().inverse();
  grid.first.resize(n, steps + 1);
  grid.second.resize(n, steps + 1);
  grid.ceiling.resize(steps + 1);
  JointRows q;
  for (Eigen::Index i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) * grid.step;
    math::evaluate(course.spline, u, q);
    const double slower = slowdown_at(course, u) * slowdown_at(course, u);
    grid.first.col(i) = slower * q.row(1).transpose().array() * inverse;
    grid.second.col(i) = slower * q.row(2).transpose().array() * inverse;
    const double pace = most_pace(course, u, q);
    grid.ceiling[i] = pace * pace;
  }
  return grid;
}

}  // namespace morphe::retime
