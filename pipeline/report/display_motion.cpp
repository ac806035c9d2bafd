#include "pipeline/report/display_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/metrics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/report/select_display_rows.hpp"

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
  JointRows out(rows.size(), values.cols());
  for (std::size_t k = 0; k < rows.size(); ++k) out.row(k) = values.row(rows[k]);
  return out;
}

JointRows limit_ratios(const JointRows& values, const JointVector& limit) {
  return values.array().rowwise() / limit.transpose().array();
}

/// Computes the values that are greatest in magnitude from each displayed row up to the next.
JointRows maxima_between_rows(const JointRows& values, const Rows& rows) {
  JointRows out = JointRows::Zero(rows.size(), values.cols());
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    auto greatest = out.row(k);
    for (int row = rows[k]; row < rows[k + 1]; ++row) {
      for (Eigen::Index joint = 0; joint < values.cols(); ++joint) {
        if (std::abs(values(row, joint)) > std::abs(greatest[joint]))
          greatest[joint] = values(row, joint);
      }
    }
  }
  if (out.rows() > 1) out.row(out.rows() - 1) = out.row(out.rows() - 2);
  return out;
}

void add_separations(const collision::CollisionWorld& world, DisplayMotion& motion) {
  collision::CollisionScratch scratch;
  std::vector<collision::PairSeparation> near;
  const auto capsules = static_cast<int>(world.robot->capsules.size());
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    const double time_s = motion.demonstration_time[k];
    const JointVector q = motion.position.row(k).transpose();
    collision::PairSeparation nearest = collision::least_slack(world, q, time_s, scratch);
    const double wide =
        world.tolerances.max_penetration + world.tolerances.required_clearance + kTouchDistance_m;
    near.clear();
    collision::near_pairs(world, q, time_s, wide, scratch, near);
    for (const collision::PairSeparation& pair : near) {
      if (pair.separation.distance > kTouchDistance_m) continue;
      const int other = pair.other_is_object ? capsules + pair.other : pair.other;
      motion.touching_pairs.push_back({static_cast<int>(k), pair.capsule, other});
    }
    motion.nearest.push_back(nearest);
    const bool moved = world.target >= 0 && collision::target_state_at(world, time_s) !=
                                                collision::TargetState::as_recorded;
    motion.target_moved.push_back(moved ? 1 : 0);
    motion.target_pose.push_back(moved ? scratch.object_poses[world.target] : Pose::Identity());
  }
}

/// Computes the errors of the tips with respect to their goals at the demonstration time of each
/// row, and metric A.
void add_goal_errors(const robot::Robot& robot, const Goals& goals, DisplayMotion& motion) {
  const auto rows = static_cast<Eigen::Index>(motion.time.size());
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  motion.tip_error = motion.tip_orientation_error = JointRows::Constant(rows, tips, kUnknown);
  motion.humanlikeness.assign(motion.time.size(), kUnknown);
  if (goals.frames() == 0) return;
  std::vector<Pose> base_from_frame;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double time_s = motion.demonstration_time[row];
    robot::forward_kinematics(robot, motion.position.row(row).transpose(), base_from_frame);
    for (Eigen::Index tip = 0; tip < tips; ++tip) {
      const auto i = static_cast<std::size_t>(tip);
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, i);
      const Vec3 at =
          robot::tracked_point(robot, base_from_frame, i, pad_share_at(goals, i, time_s));
      motion.tip_error(row, tip) = (at - tip_goal_at(goals, i, time_s)).norm();
      const Quat turned = tip_orientation_goal_at(goals, i, time_s);
      if (is_known(turned))
        motion.tip_orientation_error(row, tip) =
            angle_between(Quat(base_from_tip.linear()), turned);
    }
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = interpolate_point(goals.elbow_position, frame_interpolation(goals, time_s));
    if (!centres.empty() && is_known(elbow))
      motion.humanlikeness[row] = humanlike::joint_distance_sum(elbow, centres);
  }
}

std::vector<bool> tips_with_goals(const Goals& goals) {
  std::vector<bool> any(goals.tip_position.cols, false);
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    for (std::size_t tip = 0; tip < any.size(); ++tip)
      any[tip] = any[tip] || is_known(goals.tip_position(f, tip));
  }
  return any;
}

/// Computes the mean of |J q'| over the tips that have goals.
std::vector<double> tip_speed(const robot::Robot& robot, const Goals& goals,
                              const JointRows& position, const JointRows& velocity) {
  const std::vector<bool> any = tips_with_goals(goals);
  const auto count = std::ranges::count(any, true);
  std::vector<double> speed(position.rows(), kUnknown);
  if (count == 0) return speed;
  std::vector<Pose> base_from_frame;
  Eigen::Matrix3Xd jacobian(3, position.cols());
  for (Eigen::Index row = 0; row < position.rows(); ++row) {
    robot::forward_kinematics(robot, position.row(row).transpose(), base_from_frame);
    double sum = 0;
    for (std::size_t tip = 0; tip < any.size(); ++tip) {
      if (!any[tip]) continue;
      const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
      robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
      sum += (jacobian * velocity.row(row).transpose()).norm();
    }
    speed[row] = sum / static_cast<double>(count);
  }
  return speed;
}

}  // namespace

DisplayMotion display_trajectory(const std::string& name, const collision::CollisionWorld& world,
                                 const Plan& plan, const Trajectory& trajectory, bool follows) {
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
  if (!follows) return motion;
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
  for (std::size_t k = 0; k < demonstration_time.size(); ++k) {
    motion.sample.push_back(static_cast<int>(k));
    motion.time.push_back(demonstration_time[k] - demonstration_time.front());
    motion.phase.push_back(phase_at(plan.movement.phases, demonstration_time[k]));
  }
  add_separations(world, motion);
  add_goal_errors(*world.robot, plan.goals, motion);
  return motion;
}

}  // namespace morphe::report
