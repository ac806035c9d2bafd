#include <algorithm>

#include "pipeline/collision/certified.hpp"

namespace morphe {
namespace {

double from_axis(const Vec3& point, const Vec3& axis) {
  return (point - point.dot(axis) * axis).norm();
}

}  // namespace

JointRows capsule_reach(const RobotTable& robot) {
  JointRows reach = JointRows::Zero(static_cast<Eigen::Index>(robot.capsules.size()),
                                    static_cast<Eigen::Index>(robot.joints()));
  for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
    const RobotTable::Capsule& capsule = robot.capsules[c];
    // What lies beyond the next link outward, and that link: it turns with the frame, so that only
    // its part across the frame's axis counts.
    double beyond_m = capsule.radius;
    const RobotTable::Frame* outward = nullptr;
    for (int f = capsule.frame; f >= 0;) {
      const RobotTable::Frame& frame = robot.frames[static_cast<std::size_t>(f)];
      const Vec3 axis = frame.axis.normalized();
      const double link_m =
          outward ? from_axis(outward->transform.translation(), axis)
                  : std::max(from_axis(capsule.from, axis), from_axis(capsule.to, axis));
      if (frame.joint >= 0) {
        reach(static_cast<Eigen::Index>(c), frame.joint) +=
            std::abs(frame.ratio) * (link_m + beyond_m);
      }
      beyond_m += outward ? outward->transform.translation().norm()
                          : std::max(capsule.from.norm(), capsule.to.norm());
      outward = &frame;
      f = frame.parent;
    }
  }
  return reach;
}

}  // namespace morphe
