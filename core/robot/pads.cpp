#include "core/robot/pads.hpp"

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/robot.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {

std::vector<Pad> find_pads(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, JointVector::Zero(robot.joints()), base_from_frame);
  const auto pose_of = [&](int frame) {
    return frame < 0 ? Pose::Identity() : base_from_frame[frame];
  };
  std::vector<Pad> pads(robot.tips.size());
  for (std::size_t i = 0; i < pads.size(); ++i) {
    const RobotModel::Tip& tip = robot.tips[i];
    double nearest = kInfinity;
    for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
      const RobotModel::Capsule& capsule = robot.capsules[c];
      if (moving_frame_of(robot, capsule.frame) != moving_frame_of(robot, tip.frame) ||
          tip.frame < 0)
        continue;
      const Pose tip_from_capsule = pose_of(tip.frame).inverse() * pose_of(capsule.frame);
      for (const Vec3& end : {capsule.from, capsule.to}) {
        const Vec3 centre = tip_from_capsule * end;
        const double away = (centre - tip.transform.translation()).norm();
        if (away >= nearest) continue;
        nearest = away;
        pads[i] = {static_cast<int>(c), centre, capsule.radius,
                   tip.transform.linear() * Vec3::UnitX()};
      }
    }
  }
  return pads;
}

bool is_pad(const Robot& robot, int capsule) {
  return std::ranges::any_of(robot.pads, [&](const Pad& pad) { return pad.capsule == capsule; });
}

Vec3 tracked_point(const Robot& robot, const std::vector<Pose>& base_from_frame, std::size_t tip,
                   double tip_to_pad_share) {
  const RobotModel::Tip& of = robot.tips[tip];
  Vec3 point = of.transform.translation();
  if (tip_to_pad_share > 0) point += tip_to_pad_share * (robot.pads[tip].centre - point);
  return of.frame < 0 ? point : base_from_frame[of.frame] * point;
}

}  // namespace morphe::robot
