#include "stages/verify/pad.hpp"

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// Returns the frame itself or its nearest ancestor that has a joint; -1 if there is no such frame.
int moving_frame(const RobotModel& robot, int frame) {
  while (frame >= 0 && robot.frames[frame].joint < 0) frame = robot.frames[frame].parent;
  return frame;
}

}  // namespace

std::vector<PadSphere> pad_spheres(const RobotModel& robot) {
  std::vector<Pose> poses;
  frame_poses(robot, JointVector::Zero(robot.joints()), poses);
  std::vector<PadSphere> pads(robot.tips.size());
  for (int t = 0; t < std::ssize(pads); ++t) {
    const RobotModel::Tip& tip = robot.tips[t];
    double least = kInfinity;
    for (int c = 0; tip.frame >= 0 && c < std::ssize(robot.capsules); ++c) {
      const RobotModel::Capsule& capsule = robot.capsules[c];
      if (moving_frame(robot, capsule.frame) != moving_frame(robot, tip.frame)) continue;
      for (const Vec3& end : {capsule.from, capsule.to}) {
        const Vec3 centre = poses[tip.frame].inverse() * to_base_frame(poses, capsule.frame, end);
        const double distance = (centre - tip.transform.translation()).norm();
        if (!(distance < least)) continue;
        least = distance;
        pads[t] = {c, centre, tip.transform.linear().col(0), capsule.radius};
      }
    }
  }
  return pads;
}

Vec3 tracked_point(const RobotModel& robot, const std::vector<PadSphere>& pads, const Goals& goals,
                   int tip, double time_s) {
  const Vec3 own = robot.tips[tip].transform.translation();
  if (goals.tip_to_pad_share.rows == 0) return own;
  const GoalInterpolation mix = interpolate_goal_frames(goals, time_s);
  const double before = goals.tip_to_pad_share(mix.before, tip);
  const double share = before + mix.share * (goals.tip_to_pad_share(mix.after, tip) - before);
  return share == 0 ? own : Vec3(own + share * (pads[tip].centre - own));
}

}  // namespace morphe::verify
