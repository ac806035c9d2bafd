#include "stages/verify/goal_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

struct ErrorStatistics {
  double total = 0, largest = kUnknown;
  int count = 0;
  void add(double value) {
    total += value;
    largest = std::fmax(largest, value);
    ++count;
  }
  double mean() const { return count > 0 ? total / count : kUnknown; }
};

std::optional<Eigen::Vector4d> orientation_goal(const Goals& goals, int tip,
                                                const GoalInterpolation& mix) {
  if (goals.tip_orientation.rows == 0) return std::nullopt;
  const Eigen::Vector4d from = goals.tip_orientation(mix.before, tip).coeffs();
  const Eigen::Vector4d to = goals.tip_orientation(mix.after, tip).coeffs();
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  return slerp(from, to, mix.share);
}

Vec3 interpolated_point(const std::vector<Vec3>& points, const GoalInterpolation& mix) {
  if (points.empty()) return unknown_point();
  return points[mix.before] + mix.share * (points[mix.after] - points[mix.before]);
}

}  // namespace

GoalErrors goal_errors(const RobotModel& robot, const Plan& plan) {
  const Trajectory& trajectory = plan.trajectory;
  const Goals& goals = plan.goals;
  if (goals.frames() == 0) return {};
  ErrorStatistics position, grasp, orientation, upper_arm, humanlikeness;
  const std::vector<PadSphere> pads = pad_spheres(robot);
  const int elbow_centre = find_index(robot.joint_centres, "arm", &RobotModel::JointCentre::chain);
  std::vector<Pose> poses;
  for (int sample = 0; sample < std::ssize(trajectory.time); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    const GoalInterpolation mix = interpolate_goal_frames(goals, time_s);
    frame_poses(robot, trajectory.position.row(sample).transpose(), poses);
    for (int t = 0; t < std::ssize(robot.tips); ++t) {
      const RobotModel::Tip& tip = robot.tips[t];
      if (const auto goal = orientation_goal(goals, t, mix))
        orientation.add(rotation_angle(
            (tip.frame < 0 ? Pose::Identity() : poses[tip.frame]) * tip.transform, *goal));
      const auto goal = goal_at(goals, t, time_s);
      if (!goal) continue;
      const Vec3 tracked = tracked_point(robot, pads, goals, t, time_s);
      const double error = (to_base_frame(poses, tip.frame, tracked) - *goal).norm();
      position.add(error);
      if (is_grasping(plan.movement.phases, time_s)) grasp.add(error);
    }
    const Vec3 elbow = interpolated_point(goals.elbow_position, mix);
    if (elbow_centre < 0 || !elbow.allFinite()) continue;
    humanlikeness.add(squared_elbow_distances(robot, poses, elbow));
    const Vec3 human = elbow - interpolated_point(goals.shoulder_position, mix);
    if (!human.allFinite()) continue;
    const auto origin = [&](int frame) { return to_base_frame(poses, frame, Vec3::Zero()); };
    const Vec3 own = origin(robot.joint_centres[elbow_centre].frame) - origin(robot.shoulder_frame);
    upper_arm.add(2 * std::asin(std::min(1.0, (human.normalized() - own.normalized()).norm() / 2)));
  }
  return {position.largest,  position.mean(),  grasp.largest,       orientation.largest,
          upper_arm.largest, upper_arm.mean(), humanlikeness.mean()};
}

Eigen::Vector4d slerp(const Eigen::Vector4d& from, Eigen::Vector4d to, double share) {
  if (from.dot(to) < 0) to = -to;
  const double angle = 2 * std::asin(std::min(1.0, (from - to).norm() / 2));
  if (angle < 1e-12) return from;
  return (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to).normalized();
}

double rotation_angle(const Pose& pose, const Eigen::Vector4d& goal) {
  const Eigen::Vector4d own = Quat(pose.linear()).coeffs();
  const double chord = std::min((own - goal).norm(), (own + goal).norm());
  return 4 * std::asin(std::min(1.0, chord / 2));
}

double squared_elbow_distances(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                               const Vec3& elbow) {
  double sum = 0;
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    if (centre.chain == "arm")
      sum += (to_base_frame(base_from_frame, centre.frame, Vec3::Zero()) - elbow).squaredNorm();
  return sum;
}

}  // namespace morphe::verify
