#include "core/robot/pads.hpp"

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {

std::vector<Pad> find_pads(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, JointVector::Zero(robot.joints()), base_from_frame);
  const auto pose_of = [&](int frame) {
    return frame < 0 ? Pose::Identity() : base_from_frame[frame];
  };
  std::vector<Pad> pads(robot.tips.size());
  for (int i = 0; i < std::ssize(pads); ++i) {
    const RobotModel::Tip& tip = robot.tips[i];
    double nearest_m = kInfinity;
    for (int c = 0; c < std::ssize(robot.capsules); ++c) {
      const RobotModel::Capsule& capsule = robot.capsules[c];
      if (moving_frame_of(robot, capsule.frame) != moving_frame_of(robot, tip.frame) ||
          tip.frame < 0)
        continue;
      const Pose tip_from_capsule = pose_of(tip.frame).inverse() * pose_of(capsule.frame);
      for (const Vec3& end : {capsule.from, capsule.to}) {
        const Vec3 centre = tip_from_capsule * end;
        const double distance_m = (centre - tip.transform.translation()).norm();
        if (distance_m >= nearest_m) continue;
        nearest_m = distance_m;
        pads[i] = {c, centre, capsule.radius, tip.transform.linear() * Vec3::UnitX()};
      }
    }
  }
  return pads;
}

}  // namespace morphe::robot
