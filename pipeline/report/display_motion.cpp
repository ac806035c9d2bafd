#include "pipeline/report/display_motion.hpp"

#include <cmath>

#include "core/humanlike/metrics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/report/select_display_rows.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/certify/posture_errors.hpp"

namespace morphe::report {
namespace {

using Rows = std::vector<int>;

template <class T>
std::vector<T> select_rows(const std::vector<T>& values, const Rows& rows) {
  std::vector<T> out;
  for (const int row : rows) out.push_back(values[row]);
  return out;
}

JointRows select_rows(const JointRows& values, const Rows& rows) {
  return values(rows, Eigen::all);
}

JointRows limit_ratios(const JointRows& values, const JointVector& limit) {
  return values.array().rowwise() / limit.transpose().array();
}

/// Returns the values of greatest magnitude from each row to the next; the last repeats its
/// previous.
JointRows maxima_between_rows(const JointRows& values, const Rows& rows) {
  JointRows out = JointRows::Zero(rows.size(), values.cols());
  for (int k = 0; k + 1 < std::ssize(rows); ++k) {
    auto maximum = out.row(k);
    for (int row = rows[k]; row < rows[k + 1]; ++row) {
      for (Eigen::Index joint = 0; joint < values.cols(); ++joint) {
        if (std::abs(values(row, joint)) > std::abs(maximum[joint]))
          maximum[joint] = values(row, joint);
      }
    }
  }
  if (out.rows() > 1) out.row(out.rows() - 1) = out.row(out.rows() - 2);
  return out;
}

void add_separations(const collision::CollisionWorld& world, DisplayMotion& motion) {
  collision::CollisionScratch scratch;
  std::vector<collision::PairSeparation> close_pairs;
  const double margin_m =
      world.tolerances.max_penetration + world.tolerances.required_clearance + kTouchDistance_m;
  for (int k = 0; k < std::ssize(motion.time); ++k) {
    const double time_s = motion.demonstration_time[k];
    const JointVector q = motion.position.row(k).transpose();
    motion.nearest.push_back(collision::least_slack(world, q, time_s, scratch));
    close_pairs.clear();
    collision::near_pairs(world, q, time_s, margin_m, scratch, close_pairs);
    for (const collision::PairSeparation& pair : close_pairs) {
      if (pair.separation.distance <= kTouchDistance_m)
        motion.touching_pairs.push_back(
            {k, body_index(*world.robot, pair.first_is_object, pair.first),
             body_index(*world.robot, pair.other_is_object, pair.other)});
    }
    const bool moved = world.target >= 0 && collision::target_state_at(world, time_s) !=
                                                collision::TargetState::as_recorded;
    motion.target_moved.push_back(moved ? 1 : 0);
    motion.target_pose.push_back(moved ? scratch.object_poses[world.target] : Pose::Identity());
  }
}

/// Sets the errors of tips and arm against the person at the same time of the demonstration, and
/// metric A.
void add_goal_errors(const robot::Robot& robot, const Goals& goals, DisplayMotion& motion) {
  const Eigen::Index rows = std::ssize(motion.time), tips = std::ssize(robot.tips);
  motion.tip_error = motion.tip_orientation_error = JointRows::Constant(rows, tips, kUnknown);
  motion.arm_error = JointRows::Constant(rows, 4, kUnknown);
  motion.humanlikeness.assign(rows, kUnknown);
  if (goals.frames() == 0) return;
  std::vector<Pose> base_from_frame;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double time_s = motion.demonstration_time[row];
    robot::forward_kinematics(robot, motion.position.row(row).transpose(), base_from_frame);
    for (Eigen::Index tip = 0; tip < tips; ++tip) {
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, tip);
      const Vec3 position =
          robot::tracked_point(robot, base_from_frame, tip, pad_share_at(goals, tip, time_s));
      motion.tip_error(row, tip) = (position - tip_goal_at(goals, tip, time_s)).norm();
      const Quat goal = tip_orientation_goal_at(goals, tip, time_s);
      if (is_known(goal))
        motion.tip_orientation_error(row, tip) = angle_between(Quat(base_from_tip.linear()), goal);
    }
    const certify::PostureErrors posture =
        certify::posture_errors_at(robot, base_from_frame, goals, time_s);
    motion.arm_error.row(row) << certify::upper_arm_error(robot, base_from_frame, goals, time_s),
        posture.forearm, posture.swivel, posture.palm;
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = interpolate_point(goals.elbow_position, frame_interpolation(goals, time_s));
    if (!centres.empty() && is_known(elbow))
      motion.humanlikeness[row] = humanlike::joint_distance_sum(elbow, centres);
  }
}

std::vector<int> tips_with_goals(const robot::Robot& robot, const Goals& goals) {
  std::vector<int> tips;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    bool has_goal = false;
    for (std::size_t f = 0; f < goals.frames() && !has_goal; ++f)
      has_goal = is_known(goals.tip_position(f, tip));
    if (has_goal) tips.push_back(tip);
  }
  return tips;
}

/// Returns the mean of |J q'| over the tips that have goals, for each row; NaN without such tips.
std::vector<double> tip_speed(const robot::Robot& robot, const Goals& goals,
                              const JointRows& position, const JointRows& velocity) {
  const std::vector<int> tips = tips_with_goals(robot, goals);
  std::vector<double> speed(position.rows(), kUnknown);
  if (tips.empty()) return speed;
  std::vector<Pose> base_from_frame;
  Eigen::Matrix3Xd jacobian(3, position.cols());
  for (Eigen::Index row = 0; row < position.rows(); ++row) {
    robot::forward_kinematics(robot, position.row(row).transpose(), base_from_frame);
    double sum = 0;
    for (const int tip : tips) {
      const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
      robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
      sum += (jacobian * velocity.row(row).transpose()).norm();
    }
    speed[row] = sum / static_cast<double>(tips.size());
  }
  return speed;
}

}  // namespace

int body_index(const RobotModel& robot, bool is_object, int body) {
  return is_object ? static_cast<int>(robot.capsules.size()) + body : body;
}

DisplayMotion display_trajectory(const std::string& name, const collision::CollisionWorld& world,
                                 const Plan& plan, const Trajectory& trajectory,
                                 bool follows_goals) {
  const robot::Robot& robot = *world.robot;
  const Rows rows = select_display_rows(robot, trajectory, kDisplayRate_hz);
  DisplayMotion motion;
  motion.name = name;
  motion.sample = rows;
  motion.time = select_rows(trajectory.time, rows);
  motion.demonstration_time = select_rows(trajectory.demonstration_time, rows);
  motion.position = select_rows(trajectory.position, rows);
  const JointRows velocity = select_rows(trajectory.velocity, rows);
  motion.velocity = limit_ratios(velocity, robot.velocity);
  motion.acceleration =
      limit_ratios(select_rows(trajectory.acceleration, rows), robot.acceleration);
  motion.jerk = maxima_between_rows(jerk_ratios(robot, trajectory), rows);
  motion.phase = select_rows(trajectory.phase, rows);
  motion.origin = select_rows(trajectory.origin, rows);
  motion.clearance = select_rows(trajectory.clearance, rows);
  add_separations(world, motion);
  if (!follows_goals) return motion;
  add_goal_errors(robot, plan.goals, motion);
  motion.mean_tip_speed = tip_speed(robot, plan.goals, motion.position, velocity);
  return motion;
}

DisplayMotion display_path(const std::string& name, const collision::CollisionWorld& world,
                           const Plan& plan, const JointRows& position,
                           const std::vector<double>& demonstration_time,
                           const std::vector<SampleOrigin>& origin) {
  DisplayMotion motion;
  motion.name = name;
  motion.position = position;
  motion.demonstration_time = demonstration_time;
  motion.origin = origin;
  for (int k = 0; k < std::ssize(demonstration_time); ++k) {
    motion.sample.push_back(k);
    motion.time.push_back(demonstration_time[k] - demonstration_time.front());
    motion.phase.push_back(phase_at(plan.movement.phases, demonstration_time[k]));
  }
  add_separations(world, motion);
  add_goal_errors(*world.robot, plan.goals, motion);
  return motion;
}

}  // namespace morphe::report
