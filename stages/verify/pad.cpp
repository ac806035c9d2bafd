#include "stages/verify/pad.hpp"

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// Returns the nearest ancestor of a frame, or the frame itself, that has a joint.
int nearest_moving_frame(const RobotModel& robot, int frame) {
  while (frame >= 0 && robot.frames[frame].joint < 0) {
    frame = robot.frames[frame].parent;
  }
  return frame;
}

}  // namespace

std::vector<PadSphere> pad_spheres(const RobotModel& robot) {
  std::vector<Pose> poses;
  frame_poses(robot, JointVector::Zero(robot.joints()), poses);
  std::vector<PadSphere> balls;
  for (const RobotModel::Tip& tip : robot.tips) {
    PadSphere ball;
    double least = kInfinity;
    for (int c = 0; tip.frame >= 0 && c < static_cast<int>(robot.capsules.size()); ++c) {
      const RobotModel::Capsule& capsule = robot.capsules[c];
      if (nearest_moving_frame(robot, capsule.frame) != nearest_moving_frame(robot, tip.frame))
        continue;
      const Pose& at_tip = poses[tip.frame];
      for (const Vec3* end : {&capsule.from, &capsule.to}) {
        const Vec3 centre = at_tip.inverse() * to_base_frame(poses, capsule.frame, *end);
        const double away = (centre - tip.transform.translation()).norm();
        if (!(away < least)) continue;
        least = away;
        ball = {c, centre, tip.transform.linear().col(0), capsule.radius};
      }
    }
    balls.push_back(ball);
  }
  return balls;
}

Vec3 tracked_point(const RobotModel& robot, const std::vector<PadSphere>& pads, const Goals& goals,
                   std::size_t tip, double time_s) {
  const Vec3 own = robot.tips[tip].transform.translation();
  if (goals.tip_to_pad_share.rows == 0) return own;
  const GoalInterpolation at = interpolate_goal_frames(goals, time_s);
  const double before = goals.tip_to_pad_share(at.before, tip),
               after = goals.tip_to_pad_share(at.after, tip);
  const double share = before + at.share * (after - before);
  return share == 0 ? own : Vec3(own + share * (pads[tip].centre - own));
}

}  // namespace morphe::verify
