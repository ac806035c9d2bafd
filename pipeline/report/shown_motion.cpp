#include "pipeline/report/shown_motion.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/metrics.hpp"
#include "core/motion/goals_at.hpp"
#include "core/robot/forward.hpp"
#include "pipeline/report/shown_samples.hpp"

namespace morphe::report {
namespace {

using Rows = std::vector<int>;

template <class T>
std::vector<T> taken(const std::vector<T>& values, const Rows& rows) {
  std::vector<T> out;
  for (const int row : rows) out.push_back(values[static_cast<std::size_t>(row)]);
  return out;
}

JointRows taken(const JointRows& values, const Rows& rows) {
  JointRows out(static_cast<Eigen::Index>(rows.size()), values.cols());
  for (std::size_t k = 0; k < rows.size(); ++k)
    out.row(static_cast<Eigen::Index>(k)) = values.row(rows[k]);
  return out;
}

JointRows shares_of(const JointRows& values, const JointVector& limit) {
  return values.array().rowwise() / limit.transpose().array();
}

/// What is greatest in size from each shown row up to the next.
JointRows greatest_between(const JointRows& values, const Rows& rows) {
  JointRows out = JointRows::Zero(static_cast<Eigen::Index>(rows.size()), values.cols());
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    auto greatest = out.row(static_cast<Eigen::Index>(k));
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

void look_around(const collision::CollisionWorld& world, ShownMotion& motion) {
  collision::CollisionScratch scratch;
  std::vector<collision::PairSeparation> near;
  const auto capsules = static_cast<int>(world.robot->capsules.size());
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    const double time_s = motion.demonstration_time[k];
    const JointVector q = motion.position.row(static_cast<Eigen::Index>(k)).transpose();
    collision::PairSeparation nearest = collision::least_slack(world, q, time_s, scratch);
    const double wide = world.tolerances.contact_depth + world.tolerances.margin + kTouch_m;
    near.clear();
    collision::near_pairs(world, q, time_s, wide, scratch, near);
    for (const collision::PairSeparation& pair : near) {
      if (pair.separation.distance > kTouch_m) continue;
      const int other = pair.object ? capsules + pair.other : pair.other;
      motion.touching.push_back({static_cast<int>(k), pair.capsule, other});
    }
    motion.nearest.push_back(nearest);
    const bool moved = world.target >= 0 && collision::place_of_target(world, time_s) !=
                                                collision::TargetPlace::as_recorded;
    motion.target_moved.push_back(moved ? 1 : 0);
    motion.target_pose.push_back(
        moved ? scratch.object_poses[static_cast<std::size_t>(world.target)] : Pose::Identity());
  }
}

/// Tips against their goals at each row's demonstration time, metric A beside them.
void hold_against_goals(const robot::Robot& robot, const Goals& goals, ShownMotion& motion) {
  const auto rows = static_cast<Eigen::Index>(motion.time.size());
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  motion.tip_error = motion.orientation_error = JointRows::Constant(rows, tips, kNotSeen);
  motion.humanlikeness.assign(motion.time.size(), kNotSeen);
  if (goals.frames() == 0) return;
  std::vector<Pose> base_from_frame;
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double time_s = motion.demonstration_time[static_cast<std::size_t>(row)];
    robot::forward(robot, motion.position.row(row).transpose(), base_from_frame);
    for (Eigen::Index tip = 0; tip < tips; ++tip) {
      const auto i = static_cast<std::size_t>(tip);
      const Pose base_from_tip = robot::tip_pose(robot, base_from_frame, i);
      const Vec3 at = robot::goal_point(robot, base_from_frame, i, pad_share_at(goals, i, time_s));
      motion.tip_error(row, tip) = (at - tip_goal_at(goals, i, time_s)).norm();
      const Quat turned = tip_orientation_goal_at(goals, i, time_s);
      if (seen(turned))
        motion.orientation_error(row, tip) = angle_between(Quat(base_from_tip.linear()), turned);
    }
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, base_from_frame);
    const Vec3 elbow = point_at(goals.elbow_position, goal_time(goals, time_s));
    if (!centres.empty() && seen(elbow))
      motion.humanlikeness[static_cast<std::size_t>(row)] =
          humanlike::joint_distance_sum(elbow, centres);
  }
}

std::vector<bool> tips_with_goals(const Goals& goals) {
  std::vector<bool> any(goals.tip_position.cols, false);
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    for (std::size_t tip = 0; tip < any.size(); ++tip)
      any[tip] = any[tip] || seen(goals.tip_position(f, tip));
  }
  return any;
}

/// Mean of |J q'| over the tips that have goals.
std::vector<double> tip_speed(const robot::Robot& robot, const Goals& goals,
                              const JointRows& position, const JointRows& velocity) {
  const std::vector<bool> any = tips_with_goals(goals);
  const auto count = std::ranges::count(any, true);
  std::vector<double> speed(static_cast<std::size_t>(position.rows()), kNotSeen);
  if (count == 0) return speed;
  std::vector<Pose> base_from_frame;
  Eigen::Matrix3Xd jacobian(3, position.cols());
  for (Eigen::Index row = 0; row < position.rows(); ++row) {
    robot::forward(robot, position.row(row).transpose(), base_from_frame);
    double sum = 0;
    for (std::size_t tip = 0; tip < any.size(); ++tip) {
      if (!any[tip]) continue;
      const Vec3 point = robot::tip_pose(robot, base_from_frame, tip).translation();
      robot::point_jacobian(robot, base_from_frame, robot.tips[tip].frame, point, jacobian);
      sum += (jacobian * velocity.row(row).transpose()).norm();
    }
    speed[static_cast<std::size_t>(row)] = sum / static_cast<double>(count);
  }
  return speed;
}

}  // namespace

ShownMotion shown_trajectory(const std::string& name, const collision::CollisionWorld& world,
                             const Plan& plan, const Trajectory& trajectory, bool follows) {
  const robot::Robot& robot = *world.robot;
  const Rows rows = shown_samples(robot, trajectory, kShownHz);
  ShownMotion motion;
  motion.name = name;
  motion.sample = rows;
  motion.time = taken(trajectory.time, rows);
  motion.demonstration_time = taken(trajectory.demonstration_time, rows);
  motion.position = taken(trajectory.position, rows);
  const JointRows velocity = taken(trajectory.velocity, rows);
  motion.velocity = shares_of(velocity, robot.velocity);
  motion.acceleration = shares_of(taken(trajectory.acceleration, rows), robot.acceleration);
  motion.jerk = greatest_between(jerk_shares(robot, trajectory), rows);
  motion.phase = taken(trajectory.phase, rows);
  motion.origin = taken(trajectory.origin, rows);
  motion.clearance = taken(trajectory.clearance, rows);
  look_around(world, motion);
  if (!follows) return motion;
  hold_against_goals(robot, plan.goals, motion);
  motion.speed = tip_speed(robot, plan.goals, motion.position, velocity);
  return motion;
}

ShownMotion shown_path(const std::string& name, const collision::CollisionWorld& world,
                       const Plan& plan, const JointRows& position,
                       const std::vector<double>& demonstration_time,
                       const std::vector<Origin>& origin) {
  ShownMotion motion;
  motion.name = name;
  motion.position = position;
  motion.demonstration_time = demonstration_time;
  motion.origin = origin;
  for (std::size_t k = 0; k < demonstration_time.size(); ++k) {
    motion.sample.push_back(static_cast<int>(k));
    motion.time.push_back(demonstration_time[k] - demonstration_time.front());
    motion.phase.push_back(phase_at(plan.movement.phases, demonstration_time[k]));
  }
  look_around(world, motion);
  hold_against_goals(*world.robot, plan.goals, motion);
  return motion;
}

}  // namespace morphe::report
