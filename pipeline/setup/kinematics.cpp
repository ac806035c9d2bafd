#include "pipeline/setup/kinematics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::setup {

Line Kinematics::axis(int f) const {
  return {pose(f).translation(), pose(f).linear() * frame(f).axis};
}

double Kinematics::closing_sign(int f) const {
  const RobotModel::Frame& moved = frame(f);
  const double up = table().upper[moved.joint] - rest[moved.joint];
  const double down = rest[moved.joint] - table().lower[moved.joint];
  return (up >= down ? 1 : -1) * (moved.ratio >= 0 ? 1 : -1);
}

JointVector rest_position(const RobotModel& robot) {
  return JointVector::Zero(robot.lower.size()).cwiseMax(robot.lower).cwiseMin(robot.upper);
}

Kinematics kinematics_of(const robot::UrdfModel& model) {
  Kinematics robot;
  robot.model = &model;
  const RobotModel& table = model.table;
  robot.rest = rest_position(table);
  robot::forward_kinematics(table, robot.rest, robot.base_from_frame);
  robot.children.resize(table.frames.size());
  for (int f = 0; f < std::ssize(table.frames); ++f)
    if (const int parent = table.frames[f].parent; parent >= 0) robot.children[parent].push_back(f);
  robot.link = model.link_of_frame();
  return robot;
}

std::vector<int> joint_frames_between(const Kinematics& robot, int above, int frame) {
  std::vector<int> found;
  for (int f = frame; f >= 0 && f != above; f = robot.frame(f).parent)
    if (robot.moves(f)) found.push_back(f);
  std::ranges::reverse(found);
  return found;
}

Vec3 project_onto_line(const Line& line, const Vec3& point) {
  return line.point + (point - line.point).dot(line.direction) * line.direction;
}

Vec3 point_nearest_to_lines(const std::vector<Line>& lines) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vec3 sum = Vec3::Zero();
  for (const Line& line : lines) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - line.direction * line.direction.transpose();
    normal += across;
    sum += across * line.point;
  }
  return normal.ldlt().solve(sum);
}

double distance(const Line& line, const Vec3& point) {
  return (project_onto_line(line, point) - point).norm();
}

double distance(const Line& one, const Line& other) {
  const Vec3 normal = one.direction.cross(other.direction);
  if (are_parallel(one, other)) return distance(one, other.point);
  return std::abs((other.point - one.point).dot(normal.normalized()));
}

bool are_parallel(const Line& one, const Line& other) {
  constexpr double kMaxSine = 0.1;  // 6 degrees
  return one.direction.cross(other.direction).norm() < kMaxSine;
}

}  // namespace morphe::setup
