#include "stages/certify/goal_errors.hpp"

#include <algorithm>
#include <cmath>

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

double angle_of(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Returns the distance of a tip, or of its pad's centre, from its goal at a demonstration time;
/// NaN if it has no goal at that time.
double goal_error(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                  const Goals& goals, std::size_t tip, double time_s) {
  const Vec3 goal = tip_goal_at(goals, tip, time_s);
  if (!is_known(goal)) return kUnknown;
  const double share = pad_share_at(goals, tip, time_s);
  return (robot::tracked_point(robot, base_from_frame, tip, share) - goal).norm();
}

double tolerance_of(const Tolerances& tolerances, bool grasp) {
  return grasp ? tolerances.tracking_tolerance_grasp : tolerances.tracking_tolerance;
}

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
    const bool grasp = is_grasping_at(movement, time_s);
    const double tolerance = tolerance_of(tolerances, grasp);
    robot::forward_kinematics(robot, trajectory.position.row(sample).transpose(), base_from_frame);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, tip);
      const Quat turned = tip_orientation_goal_at(goals, tip, time_s);
      if (is_known(turned)) {
        const double angle = angle_between(Quat(base_from_tip.linear()), turned);
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
      out.worst_sample = static_cast<int>(sample);
      out.worst_tip = static_cast<int>(tip);
    }
    const FrameInterpolation at = frame_interpolation(goals, time_s);
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = interpolate_point(goals.elbow_position, at);
    if (centres.empty() || !is_known(elbow)) continue;
    humanlikeness.add(humanlike::joint_distance_sum(elbow, centres));
    const Vec3 human = elbow - interpolate_point(goals.shoulder_position, at);
    if (!is_known(human)) continue;
    const double angle = angle_of(human, centres.front() - base_from_frame[shoulder].translation());
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
  const auto joints = static_cast<std::size_t>(trajectory.position.cols());
  std::vector<math::QuinticPiece> pieces(joints);
  JointVector q(trajectory.position.cols());
  std::vector<Pose> base_from_frame;
  for (std::size_t sample = 0; sample + 1 < trajectory.samples(); ++sample) {
    const double step_s = trajectory.time[sample + 1] - trajectory.time[sample];
    const double parts = std::ceil(step_s / kMaxCheckPeriod_s - kRoundingTolerance);
    if (parts < 2) continue;
    for (std::size_t joint = 0; joint < joints; ++joint)
      pieces[joint] = math::quintic_piece(trajectory, sample, joint);
    for (double part = 1; part < parts; ++part) {
      const double share = part / parts;
      for (std::size_t joint = 0; joint < joints; ++joint)
        q[joint] = math::value_at(pieces[joint], share * step_s);
      robot::forward_kinematics(robot, q, base_from_frame);
      const double time_s = std::lerp(trajectory.demonstration_time[sample],
                                      trajectory.demonstration_time[sample + 1], share);
      const double tolerance = tolerance_of(tolerances, is_grasping_at(movement, time_s));
      for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
        const double error = goal_error(robot, base_from_frame, goals, tip, time_s);
        if (std::isnan(error) || error - tolerance <= out.excess) continue;
        out = {error - tolerance,
               error,
               tolerance,
               trajectory.time[sample] + share * step_s,
               static_cast<int>(sample),
               static_cast<int>(tip)};
      }
    }
  }
  return out;
}

}  // namespace morphe::certify
