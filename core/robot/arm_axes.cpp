#include "core/robot/arm_axes.hpp"

#include <algorithm>

#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

/// Sine of an angle of one degree: axes that a description states with rounded numbers are within.
constexpr double kMinSine = 0.0175;

double sine(const ArmAxes& axes, int hinge, int other) {
  return axes.direction[hinge].cross(axes.direction[other]).norm();
}

Vec3 nearest_to_axis(const ArmAxes& axes, int hinge, int other) {
  const Vec3 &a = axes.direction[hinge], &b = axes.direction[other];
  const Vec3 between = axes.point[other] - axes.point[hinge];
  const double cosine = a.dot(b);
  const double along = (between.dot(a) - cosine * between.dot(b)) / (1 - cosine * cosine);
  return axes.point[hinge] + along * a;
}

}  // namespace

std::vector<int> arm_hinges(const RobotModel& robot) {
  std::vector<int> hinges;
  for (const int frame : ancestors(robot, robot.palm_frame)) {
    if (joint_of(robot, frame) >= 0 && !robot.frames[frame].prismatic) hinges.push_back(frame);
  }
  std::ranges::reverse(hinges);
  return hinges;
}

ArmAxes arm_axes(const RobotModel& robot, const std::vector<int>& hinges,
                 const std::vector<Pose>& base_from_frame) {
  ArmAxes axes;
  for (const int frame : hinges) {
    axes.direction.push_back(base_from_frame[frame].linear() * robot.frames[frame].axis);
    axes.point.push_back(base_from_frame[frame].translation());
  }
  if (robot.palm_frame >= 0) axes.palm = base_from_frame[robot.palm_frame].translation();
  return axes;
}

bool are_inclined(const ArmAxes& axes, int hinge, int other) {
  return sine(axes, hinge, other) >= kMinSine;
}

double triple_product(const ArmAxes& axes, int middle) {
  if (middle < 1 || middle + 1 >= axes.count() || !are_inclined(axes, middle - 1, middle) ||
      !are_inclined(axes, middle, middle + 1))
    return kUnknown;
  const Vec3 normal = axes.direction[middle].cross(axes.direction[middle + 1]);
  return axes.direction[middle - 1].dot(normal) / (normal.norm() * sine(axes, middle - 1, middle));
}

Vec3 foot_point(const ArmAxes& axes, int hinge, int neighbour, int other) {
  for (const int k : {neighbour, other}) {
    if (k >= 0 && k < axes.count() && are_inclined(axes, hinge, k))
      return nearest_to_axis(axes, hinge, k);
  }
  const Vec3 &a = axes.direction[hinge], &point = axes.point[hinge];
  return hinge + 1 < axes.count() ? point : Vec3(point + (axes.palm - point).dot(a) * a);
}

Vec3 lever_from_axis(const ArmAxes& axes, int hinge, const Vec3& point) {
  const Vec3 away = point - axes.point[hinge];
  return away - away.dot(axes.direction[hinge]) * axes.direction[hinge];
}

}  // namespace morphe::robot
