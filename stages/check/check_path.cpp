#include "stages/check/check_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/joint_unit.hpp"
#include "core/robot/tree.hpp"
#include "stages/check/check_collisions.hpp"
#include "stages/check/finding_rows.hpp"

namespace morphe::check {
namespace {

constexpr double kLimitTolerance_rad = 1e-9;  ///< rounding of positions clamped to a limit
constexpr double kJumpPeriod_s = 0.01;        ///< time to which jump_threshold refers
constexpr double kMinJumpRatio = 3;           ///< ratio of a jump to the mean of its neighbours

void check_limits(const RobotModel& robot, const JointPath& path, FindingRows& rows) {
  for (int k = 0; k < std::ssize(path.demonstration_time); ++k) {
    for (int j = 0; j < robot.lower.size(); ++j) {
      const double q = path.position(k, j);
      const double below = robot.lower[j] - q, above = q - robot.upper[j];
      const double beyond = std::isnan(q) ? kInfinity : std::max(below, above);
      if (!(beyond > kLimitTolerance_rad)) continue;
      rows.add({.cause = Cause::joint_limit,
                .subject = robot.joint_names[j],
                .excess = beyond,
                .unit = robot::joint_unit(robot, j),
                .limit = below > above ? robot.lower[j] : robot.upper[j]},
               k, k);
    }
  }
}

void check_tracking(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                    const JointPath& path, const Tolerances& tolerances, FindingRows& rows) {
  if (goals.frames() == 0) return;
  assert(goals.tip_position.cols == robot.tips.size());
  std::vector<Pose> base_from_frame;
  for (int k = 0; k < std::ssize(path.demonstration_time); ++k) {
    const double time_s = path.demonstration_time[k];
    const bool grasp = counts_as_grasp(movement, path.demonstration_time, k);
    const double allowed_m =
        grasp ? tolerances.tracking_tolerance_grasp : tolerances.tracking_tolerance;
    const JointVector q = path.position.row(k);
    robot::forward_kinematics(robot, q, base_from_frame);
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      const Vec3 goal = tip_goal_at(goals, tip, time_s);
      if (!is_known(goal)) continue;
      const Vec3 reached =
          robot::tracked_point(robot, base_from_frame, tip, pad_share_at(goals, tip, time_s));
      const double beyond_m = (reached - goal).norm() - allowed_m;
      if (!(beyond_m > 0)) continue;
      rows.add({.cause = Cause::tracking,
                .subject = robot.tips[tip].name,
                .excess = beyond_m,
                .limit = allowed_m},
               k, k);
    }
  }
}

/// Returns the absolute steps of one joint, scaled to 10 ms unless both samples have the same time.
std::vector<double> steps_of(const JointPath& path, Eigen::Index joint) {
  std::vector<double> steps;
  for (int k = 0; k + 1 < std::ssize(path.demonstration_time); ++k) {
    const double duration_s = path.demonstration_time[k + 1] - path.demonstration_time[k];
    const double step = std::abs(path.position(k + 1, joint) - path.position(k, joint));
    steps.push_back(duration_s > 0 ? step * kJumpPeriod_s / duration_s : step);
  }
  return steps;
}

double mean_of_neighbours(const std::vector<double>& steps, int k) {
  if (steps.size() == 1) return 0;
  if (k == 0) return steps[1];
  if (k + 1 == std::ssize(steps)) return steps[k - 1];
  return 0.5 * (steps[k - 1] + steps[k + 1]);
}

void check_jumps(const RobotModel& robot, const JointPath& path, double jump_threshold,
                 FindingRows& rows) {
  const auto planned = [&path](int k) {
    return k < std::ssize(path.origin) && path.origin[k] == SampleOrigin::planned;
  };
  for (int j = 0; j < robot.lower.size(); ++j) {
    const std::vector<double> steps = steps_of(path, j);
    const double limit = jump_threshold * (robot::is_prismatic(robot, j) ? kLeverOfRadian_m : 1);
    for (int k = 0; k < std::ssize(steps); ++k) {
      if (steps[k] <= limit || planned(k) || planned(k + 1)) continue;
      if (steps[k] <= kMinJumpRatio * mean_of_neighbours(steps, k)) continue;
      rows.add({.cause = Cause::jump,
                .subject = robot.joint_names[j],
                .excess = steps[k] - limit,
                .unit = robot::joint_unit(robot, j),
                .limit = limit},
               k, k + 1);
    }
  }
}

}  // namespace

bool counts_as_grasp(const Movement& movement, const std::vector<double>& time, std::ptrdiff_t k) {
  return is_grasping_at(movement, time[k]) || (k > 0 && is_grasping_at(movement, time[k - 1])) ||
         (k + 1 < std::ssize(time) && is_grasping_at(movement, time[k + 1]));
}

std::vector<Finding> check_path(const collision::CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options) {
  assert(path.position.rows() == std::ssize(path.demonstration_time));
  FindingRows rows;
  collision::CollisionWorld with_target = world;
  collision::attach_target(path.demonstration_time, path.position, with_target);
  (options.engine == Engine::fcl ? check_with_fcl : check_certified)(with_target, path, rows);
  check_limits(*world.robot, path, rows);
  check_tracking(*world.robot, goals, movement, path, options.tolerances, rows);
  check_jumps(*world.robot, path, options.jump_threshold, rows);
  return rows.join(path.demonstration_time);
}

}  // namespace morphe::check
