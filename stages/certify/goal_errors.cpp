#include "stages/certify/goal_errors.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/humanlike/metrics.hpp"
#include "pipeline/motion/goals_at.hpp"
#include "pipeline/robot/forward.hpp"

namespace morphe::certify {
namespace {

struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return count > 0 ? sum / count : kNotSeen; }
};

double angle_of(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

GoalErrors goal_errors(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                       const Tolerances& tolerances, const Trajectory& trajectory) {
  GoalErrors out;
  if (goals.frames() == 0) return out;
  Mean position, upper_arm, humanlikeness;
  std::vector<Pose> base_from_frame;
  const auto shoulder = static_cast<std::size_t>(robot.shoulder_frame);
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    const bool grasp = grasping_at(movement, time_s);
    const double tolerance = grasp ? tolerances.tracking_grasp : tolerances.tracking;
    robot::forward(robot, trajectory.position.row(static_cast<Eigen::Index>(sample)).transpose(),
                   base_from_frame);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, tip);
      const Quat turned = tip_orientation_goal_at(goals, tip, time_s);
      if (seen(turned)) {
        const double angle = angle_between(Quat(base_from_tip.linear()), turned);
        out.orientation_max = std::fmax(out.orientation_max, angle);
      }
      const Vec3 goal = tip_goal_at(goals, tip, time_s);
      if (!seen(goal)) continue;
      const double share = pad_share_at(goals, tip, time_s);
      const double error = (robot::goal_point(robot, base_from_frame, tip, share) - goal).norm();
      position.add(error);
      out.position_max = std::fmax(out.position_max, error);
      if (grasp) out.position_grasp = std::fmax(out.position_grasp, error);
      if (out.worst_sample >= 0 && error - tolerance <= out.worst_excess) continue;
      out.worst_excess = error - tolerance;
      out.worst_error = error;
      out.worst_tolerance = tolerance;
      out.worst_sample = static_cast<int>(sample);
      out.worst_tip = static_cast<int>(tip);
    }
    const GoalTime at = goal_time(goals, time_s);
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = point_at(goals.elbow_position, at);
    if (centres.empty() || !seen(elbow)) continue;
    humanlikeness.add(humanlike::joint_distance_sum(elbow, centres));
    const Vec3 human = elbow - point_at(goals.shoulder_position, at);
    if (!seen(human)) continue;
    const double angle = angle_of(human, centres.front() - base_from_frame[shoulder].translation());
    upper_arm.add(angle);
    out.upper_arm_max = std::fmax(out.upper_arm_max, angle);
  }
  out.position_mean = position.value();
  out.upper_arm_mean = upper_arm.value();
  out.humanlikeness = humanlikeness.value();
  return out;
}

}  // namespace morphe::certify
