#include "core/robot/levers.hpp"

#include <algorithm>

namespace morphe::robot {
namespace {

double from_axis(const Vec3& point, const Vec3& axis) {
  return (point - point.dot(axis) * axis).norm();
}

/// How far a frame can slide from where its transform puts it.
double longest_slide(const RobotTable& robot, const RobotTable::Frame& frame) {
  if (!frame.slides || frame.joint < 0) return 0;
  const auto way = [&](double q) { return std::abs(frame.ratio * q + frame.offset); };
  return std::max(way(robot.lower[frame.joint]), way(robot.upper[frame.joint]));
}

/// Adds the lever arms on what lies within `radius` of the segment to `row` [joints].
template <class Row>
void add_levers(const RobotTable& robot, int frame_index, const Vec3& from, const Vec3& to,
                double radius, Row row) {
  // What lies beyond the next link outward, and that link: it turns with the frame, so that only
  // its part across the frame's axis counts.
  double beyond_m = radius;
  const RobotTable::Frame* outward = nullptr;
  for (int f = frame_index; f >= 0;) {
    const RobotTable::Frame& frame = robot.frames[static_cast<std::size_t>(f)];
    const Vec3 axis = frame.axis.normalized();
    if (outward) beyond_m += longest_slide(robot, *outward);
    const double link_m = outward ? from_axis(outward->transform.translation(), axis)
                                  : std::max(from_axis(from, axis), from_axis(to, axis));
    if (frame.joint >= 0) {
      row[frame.joint] += std::abs(frame.ratio) * (frame.slides ? 1 : link_m + beyond_m);
    }
    beyond_m +=
        outward ? outward->transform.translation().norm() : std::max(from.norm(), to.norm());
    outward = &frame;
    f = frame.parent;
  }
}

}  // namespace

JointRows levers_of_capsules(const RobotTable& robot) {
  JointRows levers = JointRows::Zero(static_cast<Eigen::Index>(robot.capsules.size()),
                                     static_cast<Eigen::Index>(robot.joints()));
  for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
    const RobotTable::Capsule& capsule = robot.capsules[c];
    add_levers(robot, capsule.frame, capsule.from, capsule.to, capsule.radius,
               levers.row(static_cast<Eigen::Index>(c)));
  }
  return levers;
}

JointVector levers_of_ball(const RobotTable& robot, int frame, const Vec3& centre, double radius) {
  JointVector levers = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  add_levers(robot, frame, centre, centre, radius, Eigen::Ref<JointVector>(levers));
  return levers;
}

}  // namespace morphe::robot
