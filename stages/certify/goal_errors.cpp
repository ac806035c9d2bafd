#include "stages/certify/goal_errors.hpp"

#include <cmath>

#include "core/humanlike/arm_posture.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/quintic.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::certify {
namespace {

struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return count > 0 ? sum / count : kUnknown; }
};

/// Returns the distance of a tip from its goal at a demonstration time; NaN without a goal.
double goal_error(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                  const Goals& goals, int tip, double time_s) {
  const Vec3 goal = tip_goal_at(goals, tip, time_s);
  if (!is_known(goal)) return kUnknown;
  const double share = pad_share_at(goals, tip, time_s);
  return (robot::tracked_point(robot, base_from_frame, tip, share) - goal).norm();
}

double tolerance_of(const Tolerances& tolerances, bool grasp) {
  return grasp ? tolerances.tracking_tolerance_grasp : tolerances.tracking_tolerance;
}

}  // namespace

double upper_arm_error(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                       const Goals& goals, double time_s) {
  const FrameInterpolation frame = frame_interpolation(goals, time_s);
  const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
  const Vec3 human = interpolate_point(goals.elbow_position, frame) -
                     interpolate_point(goals.shoulder_position, frame);
  if (centres.empty() || !is_known(human)) return kUnknown;
  const Pose& shoulder = base_from_frame[robot.shoulder_frame];
  return humanlike::direction_error(human, centres.front() - shoulder.translation());
}

GoalErrors goal_errors(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                       const Tolerances& tolerances, const Trajectory& trajectory) {
  GoalErrors out;
  if (goals.frames() == 0) return out;
  Mean position, upper_arm, humanlikeness;
  std::vector<Pose> base_from_frame;
  for (int sample = 0; sample < std::ssize(trajectory.time); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    const bool grasp = is_grasping_at(movement, time_s);
    const double tolerance = tolerance_of(tolerances, grasp);
    robot::forward_kinematics(robot, trajectory.position.row(sample).transpose(), base_from_frame);
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, tip);
      const Quat goal = tip_orientation_goal_at(goals, tip, time_s);
      if (is_known(goal)) {
        const double angle = angle_between(Quat(base_from_tip.linear()), goal);
        out.orientation_max = std::fmax(out.orientation_max, angle);
      }
      const double error = goal_error(robot, base_from_frame, goals, tip, time_s);
      if (std::isnan(error)) continue;
      position.add(error);
      out.position_max = std::fmax(out.position_max, error);
      if (grasp) out.position_grasp = std::fmax(out.position_grasp, error);
      if (out.worst_sample >= 0 && error - tolerance <= out.worst_excess) continue;
      out.worst_excess = error - tolerance;
      out.worst_error = error;
      out.worst_tolerance = tolerance;
      out.worst_sample = sample;
      out.worst_tip = tip;
    }
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = interpolate_point(goals.elbow_position, frame_interpolation(goals, time_s));
    if (centres.empty() || !is_known(elbow)) continue;
    humanlikeness.add(humanlike::joint_distance_sum(elbow, centres));
    const double angle = upper_arm_error(robot, base_from_frame, goals, time_s);
    if (std::isnan(angle)) continue;
    upper_arm.add(angle);
    out.upper_arm_max = std::fmax(out.upper_arm_max, angle);
  }
  out.position_mean = position.value();
  out.upper_arm_mean = upper_arm.value();
  out.humanlikeness = humanlikeness.value();
  return out;
}

InterSampleTipError worst_inter_sample_error(const robot::Robot& robot, const Goals& goals,
                                             const Movement& movement, const Tolerances& tolerances,
                                             const Trajectory& trajectory) {
  constexpr double kMaxCheckPeriod_s = 0.002, kRoundingTolerance = 1e-6;
  InterSampleTipError out;
  if (goals.frames() == 0) return out;
  const Eigen::Index joints = trajectory.position.cols();
  std::vector<math::QuinticPiece> pieces(joints);
  JointVector q(joints);
  std::vector<Pose> base_from_frame;
  for (int sample = 0; sample + 1 < std::ssize(trajectory.time); ++sample) {
    const double step_s = trajectory.time[sample + 1] - trajectory.time[sample];
    const double parts = std::ceil(step_s / kMaxCheckPeriod_s - kRoundingTolerance);
    if (parts < 2) continue;
    for (int j = 0; j < joints; ++j) pieces[j] = math::quintic_piece(trajectory, sample, j);
    for (double part = 1; part < parts; ++part) {
      const double share = part / parts;
      for (int j = 0; j < joints; ++j) q[j] = math::value_at(pieces[j], share * step_s);
      robot::forward_kinematics(robot, q, base_from_frame);
      const double time_s = std::lerp(trajectory.demonstration_time[sample],
                                      trajectory.demonstration_time[sample + 1], share);
      const double tolerance = tolerance_of(tolerances, is_grasping_at(movement, time_s));
      for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
        const double error = goal_error(robot, base_from_frame, goals, tip, time_s);
        if (std::isnan(error) || error - tolerance <= out.excess) continue;
        const double trajectory_s = trajectory.time[sample] + share * step_s;
        out = {error - tolerance, error, tolerance, trajectory_s, sample, tip};
      }
    }
  }
  return out;
}

}  // namespace morphe::certify
