#include "stages/verify/against_goals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

struct Sum {
  double total = 0, largest = kNotSeen;
  int count = 0;
  void add(double value) {
    total += value;
    largest = std::fmax(largest, value);
    ++count;
  }
  double mean() const { return count > 0 ? total / count : kNotSeen; }
};

/// Angle of the rotation between two unit quaternions: 4 times the half of the chord's angle.
double turn_between(const Eigen::Vector4d& a, const Eigen::Vector4d& b) {
  const double near = std::min((a - b).norm(), (a + b).norm());
  return 4 * std::asin(std::min(1.0, near / 2));
}

/// Between two rotations by the share of the way, the shorter way round.
Eigen::Vector4d turned_between(const Eigen::Vector4d& from, Eigen::Vector4d to, double share) {
  if (from.dot(to) < 0) to = -to;
  const double angle = 2 * std::asin(std::min(1.0, (from - to).norm() / 2));
  if (angle < 1e-12) return from;
  return (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to).normalized();
}

Eigen::Vector4d quaternion_of(const Quat& q) { return q.coeffs(); }

std::optional<Eigen::Vector4d> orientation_goal(const Goals& goals, std::size_t tip,
                                                const GoalShare& at) {
  if (goals.tip_orientation.rows == 0) return std::nullopt;
  const Eigen::Vector4d from = quaternion_of(goals.tip_orientation(at.before, tip));
  const Eigen::Vector4d to = quaternion_of(goals.tip_orientation(at.after, tip));
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  return turned_between(from, to, at.share);
}

Vec3 point_at(const std::vector<Vec3>& points, const GoalShare& at) {
  if (points.empty()) return unseen_point();
  return points[at.before] + at.share * (points[at.after] - points[at.before]);
}

}  // namespace

AgainstGoals against_goals(const RobotTable& robot, const Plan& plan) {
  AgainstGoals out;
  const Trajectory& trajectory = plan.trajectory;
  if (plan.goals.frames() == 0) return out;
  Sum position, grasp, orientation, upper_arm, humanlikeness;
  const std::vector<PadBall> pads = pad_balls(robot);
  std::vector<Pose> poses;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    const GoalShare at = goal_share(plan.goals, time_s);
    frame_poses(robot, trajectory.position.row(static_cast<Eigen::Index>(sample)).transpose(),
                poses);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const RobotTable::Tip& which = robot.tips[tip];
      if (const auto goal = orientation_goal(plan.goals, tip, at)) {
        const Pose pose =
            (which.frame < 0 ? Pose::Identity() : poses[static_cast<std::size_t>(which.frame)]) *
            which.transform;
        orientation.add(turn_between(quaternion_of(Quat(pose.linear())), *goal));
      }
      const auto goal = goal_at(plan.goals, tip, time_s);
      if (!goal) continue;
      const double error =
          (in_base(poses, which.frame, asked_point(robot, pads, plan.goals, tip, time_s)) - *goal)
              .norm();
      position.add(error);
      if (is_grasping(plan.movement.phases, time_s)) grasp.add(error);
    }
    const Vec3 elbow = point_at(plan.goals.elbow_position, at);
    double distances = 0;
    const RobotTable::Centre* first = nullptr;
    for (const RobotTable::Centre& centre : robot.centres) {
      if (centre.chain != "arm") continue;
      if (!first) first = &centre;
      distances += (in_base(poses, centre.frame, Vec3::Zero()) - elbow).squaredNorm();
    }
    if (!first || !elbow.allFinite()) continue;
    humanlikeness.add(distances);
    const Vec3 human = elbow - point_at(plan.goals.shoulder_position, at);
    if (!human.allFinite()) continue;
    const Vec3 own = in_base(poses, first->frame, Vec3::Zero()) -
                     in_base(poses, robot.shoulder_frame, Vec3::Zero());
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
