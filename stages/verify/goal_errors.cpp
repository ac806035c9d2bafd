#include "stages/verify/goal_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

struct Sum {
  double total = 0, largest = kUnknown;
  int count = 0;
  void add(double value) {
    total += value;
    largest = std::fmax(largest, value);
    ++count;
  }
  double mean() const { return count > 0 ? total / count : kUnknown; }
};

/// Returns the angle of the rotation between two unit quaternions: 4 times half the angle of their
/// chord.
double rotation_angle(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  const double near = std::min((a - b).norm(), (a + b).norm());
  return 4 * std::asin(std::min(1.0, near / 2));
}

/// Interpolates between two rotations, the shorter way.
Eigen::Vector4d slerp(const Eigen::Vector4d& from, Eigen::Vector4d to, double share) {
  if (from.dot(to) < 0) to = -to;
  const double angle = 2 * std::asin(std::min(1.0, (from - to).norm() / 2));
  if (angle < 1e-12) return from;
  return (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to).normalized();
}

Eigen::Vector4d quaternion_of(const Quat& q) { return q.coeffs(); }

std::optional<Eigen::Vector4d> orientation_goal(const Goals& goals, std::size_t tip,
                                                const GoalInterpolation& at) {
  if (goals.tip_orientation.rows == 0) return std::nullopt;
  const Eigen::Vector4d from = quaternion_of(goals.tip_orientation(at.before, tip));
  const Eigen::Vector4d to = quaternion_of(goals.tip_orientation(at.after, tip));
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  return slerp(from, to, at.share);
}

Vec3 point_at(const std::vector<Vec3>& points, const GoalInterpolation& at) {
  if (points.empty()) return unknown_point();
  return points[at.before] + at.share * (points[at.after] - points[at.before]);
}

}  // namespace

GoalErrors goal_errors(const RobotModel& robot, const Plan& plan) {
  GoalErrors out;
  const Trajectory& trajectory = plan.trajectory;
  if (plan.goals.frames() == 0) return out;
  Sum position, grasp, orientation, upper_arm, humanlikeness;
  const std::vector<PadSphere> pads = pad_spheres(robot);
  std::vector<Pose> poses;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    const GoalInterpolation at = interpolate_goal_frames(plan.goals, time_s);
    frame_poses(robot, trajectory.position.row(sample).transpose(), poses);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const RobotModel::Tip& which = robot.tips[tip];
      if (const auto goal = orientation_goal(plan.goals, tip, at)) {
        const Pose pose =
            (which.frame < 0 ? Pose::Identity() : poses[which.frame]) * which.transform;
        orientation.add(rotation_angle(quaternion_of(Quat(pose.linear())), *goal));
      }
      const auto goal = goal_at(plan.goals, tip, time_s);
      if (!goal) continue;
      const double error =
          (to_base_frame(poses, which.frame, tracked_point(robot, pads, plan.goals, tip, time_s)) -
           *goal)
              .norm();
      position.add(error);
      if (is_grasping(plan.movement.phases, time_s)) grasp.add(error);
    }
    const Vec3 elbow = point_at(plan.goals.elbow_position, at);
    double distances = 0;
    const RobotModel::JointCentre* first = nullptr;
    for (const RobotModel::JointCentre& centre : robot.joint_centres) {
      if (centre.chain != "arm") continue;
      if (!first) first = &centre;
      distances += (to_base_frame(poses, centre.frame, Vec3::Zero()) - elbow).squaredNorm();
    }
    if (!first || !elbow.allFinite()) continue;
    humanlikeness.add(distances);
    const Vec3 human = elbow - point_at(plan.goals.shoulder_position, at);
    if (!human.allFinite()) continue;
    const Vec3 own = to_base_frame(poses, first->frame, Vec3::Zero()) -
                     to_base_frame(poses, robot.shoulder_frame, Vec3::Zero());
    upper_arm.add(2 * std::asin(std::min(1.0, (human.normalized() - own.normalized()).norm() / 2)));
  }
  out.position_max = position.largest;
  out.position_mean = position.mean();
  out.position_grasp = grasp.largest;
  out.orientation_max = orientation.largest;
  out.upper_arm_max = upper_arm.largest;
  out.upper_arm_mean = upper_arm.mean();
  out.humanlikeness = humanlikeness.mean();
  return out;
}

}  // namespace morphe::verify
