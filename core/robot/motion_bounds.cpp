#include "core/robot/motion_bounds.hpp"

#include <algorithm>

#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

double distance_to_axis(const Vec3& point, const Vec3& axis) {
  return (point - point.dot(axis) * axis).norm();
}

double max_prismatic_extension(const RobotModel& robot, const RobotModel::Frame& frame) {
  if (!frame.prismatic || frame.joint < 0) return 0;
  const auto extension = [&](double q) { return std::abs(frame.ratio * q + frame.offset); };
  return std::max(extension(robot.lower[frame.joint]), extension(robot.upper[frame.joint]));
}

/// Adds to `row` [joints] the levers of the points within `radius` of the segment from–to, which
/// moves with a frame.
template <class Row>
void add_motion_bounds(const RobotModel& robot, int moved_frame, const Vec3& from, const Vec3& to,
                       double radius, Row row) {
  // Largest distance of the points from the origin of `outward`, the frame after the current one.
  // That origin rotates with the current frame, so only its distance from the axis counts.
  double beyond_m = radius;
  const RobotModel::Frame* outward = nullptr;
  for (const int f : ancestors(robot, moved_frame)) {
    const RobotModel::Frame& frame = robot.frames[f];
    const Vec3 axis = frame.axis.normalized();
    if (outward) beyond_m += max_prismatic_extension(robot, *outward);
    const double link_m = outward
                              ? distance_to_axis(outward->transform.translation(), axis)
                              : std::max(distance_to_axis(from, axis), distance_to_axis(to, axis));
    if (frame.joint >= 0)
      row[frame.joint] += std::abs(frame.ratio) * (frame.prismatic ? 1 : link_m + beyond_m);
    beyond_m +=
        outward ? outward->transform.translation().norm() : std::max(from.norm(), to.norm());
    outward = &frame;
  }
}

}  // namespace

JointRows capsule_motion_bounds(const RobotModel& robot) {
  JointRows levers = JointRows::Zero(robot.capsules.size(), robot.joints());
  for (int c = 0; c < std::ssize(robot.capsules); ++c) {
    const RobotModel::Capsule& capsule = robot.capsules[c];
    add_motion_bounds(robot, capsule.frame, capsule.from, capsule.to, capsule.radius,
                      levers.row(c));
  }
  return levers;
}

JointVector sphere_motion_bounds(const RobotModel& robot, int frame, const Vec3& centre,
                                 double radius) {
  JointVector levers = JointVector::Zero(robot.joints());
  add_motion_bounds(robot, frame, centre, centre, radius, Eigen::Ref<JointVector>(levers));
  return levers;
}

}  // namespace morphe::robot
