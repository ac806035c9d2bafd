#include "stages/check/check_path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/check/check_collisions.hpp"
#include "stages/check/finding_rows.hpp"

namespace morphe::check {
namespace {

/// rounding of positions that were clamped to a limit [rad]
constexpr double kLimitTolerance_rad = 1e-9;
constexpr double kJumpPeriod_s = 0.01;     ///< time to which jump_threshold refers
constexpr double kSlidePerRadian_m = 0.1;  ///< lever of a radian, the length of a finger
constexpr double kMinJumpRatio = 3;        ///< ratio of a jump to the mean of its neighbours

void check_limits(const RobotModel& robot, const JointPath& path, FindingRows& rows) {
  for (std::size_t k = 0; k < path.demonstration_time.size(); ++k) {
    for (std::size_t j = 0; j < robot.joints(); ++j) {
      const auto joint = static_cast<Eigen::Index>(j);
      const double q = path.position(k, joint);
      const double beyond = std::isnan(q)
                                ? std::numeric_limits<double>::infinity()
                                : std::max(robot.lower[joint] - q, q - robot.upper[joint]);
      if (beyond > kLimitTolerance_rad)
        rows.add(Cause::joint_limit, robot.joint_names[j], "", k, k, beyond);
    }
  }
}

void check_tracking(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                    const JointPath& path, const Tolerances& tolerances, FindingRows& rows) {
  if (goals.frames() == 0) return;
  assert(goals.tip_position.cols == robot.tips.size());
  std::vector<Pose> base_from_frame;
  for (std::size_t k = 0; k < path.demonstration_time.size(); ++k) {
    const double time_s = path.demonstration_time[k];
    const double allowed_m = counts_as_grasp(movement, path.demonstration_time, k)
                                 ? tolerances.tracking_tolerance_grasp
                                 : tolerances.tracking_tolerance;
    const JointVector q = path.position.row(k);
    robot::forward_kinematics(robot, q, base_from_frame);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Vec3 goal = tip_goal_at(goals, tip, time_s);
      if (!is_known(goal)) continue;
      const Vec3 reached =
          robot::tracked_point(robot, base_from_frame, tip, pad_share_at(goals, tip, time_s));
      const double beyond_m = (reached - goal).norm() - allowed_m;
      if (beyond_m > 0) rows.add(Cause::tracking, robot.tips[tip].name, "", k, k, beyond_m);
    }
  }
}

/// Returns the steps of one joint, scaled to 10 ms. Without time between two samples the step is
/// not scaled.
std::vector<double> steps_of(const JointPath& path, Eigen::Index joint) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < path.demonstration_time.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double taken_s = path.demonstration_time[k + 1] - path.demonstration_time[k];
    const double step = std::abs(path.position(row + 1, joint) - path.position(row, joint));
    steps.push_back(taken_s > 0 ? step * kJumpPeriod_s / taken_s : step);
  }
  return steps;
}

double mean_of_neighbours(const std::vector<double>& steps, std::size_t k) {
  if (steps.size() == 1) return 0;
  if (k == 0) return steps[1];
  if (k + 1 == steps.size()) return steps[k - 1];
  return 0.5 * (steps[k - 1] + steps[k + 1]);
}

void check_jumps(const RobotModel& robot, const JointPath& path, double jump_threshold,
                 FindingRows& rows) {
  const auto planned = [&path](std::size_t k) {
    return k < path.origin.size() && path.origin[k] == SampleOrigin::planned;
  };
  for (std::size_t j = 0; j < robot.joints(); ++j) {
    const std::vector<double> steps = steps_of(path, j);
    const double most =
        jump_threshold * (robot::is_prismatic(robot, static_cast<int>(j)) ? kSlidePerRadian_m : 1);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (steps[k] <= most || planned(k) || planned(k + 1)) continue;
      if (steps[k] <= kMinJumpRatio * mean_of_neighbours(steps, k)) continue;
      rows.add(Cause::jump, robot.joint_names[j], "", k, k + 1, steps[k] - most);
    }
  }
}

}  // namespace

bool counts_as_grasp(const Movement& movement, const std::vector<double>& time, std::size_t k) {
  return is_grasping_at(movement, time[k]) || (k > 0 && is_grasping_at(movement, time[k - 1])) ||
         (k + 1 < time.size() && is_grasping_at(movement, time[k + 1]));
}

std::string validation_error(const CheckOptions& options) {
  const Tolerances& t = options.tolerances;
  if (!(t.required_clearance >= 0)) return "required_clearance must not be negative";
  if (!(t.max_penetration >= 0)) return "max_penetration must not be negative";
  if (!(t.tracking_tolerance_grasp > 0 && t.tracking_tolerance > 0))
    return "tracking tolerances must be positive";
  if (!(t.max_unreachable_share >= 0 && t.max_unreachable_share < 1))
    return "max_unreachable_share must be at least 0 and below 1";
  if (!(t.max_tip_error > 0)) return "max_tip_error must be positive";
  if (!(options.jump_threshold > 0)) return "jump_threshold must be positive";
  return "";
}

std::vector<Finding> check_path(const collision::CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options) {
  assert(path.position.rows() == static_cast<Eigen::Index>(path.demonstration_time.size()));
  FindingRows rows;
  collision::CollisionWorld carrying = world;
  collision::attach_target(path.demonstration_time, path.position, carrying);
  check_collisions(carrying, path, options.engine, rows);
  check_limits(*world.robot, path, rows);
  check_tracking(*world.robot, goals, movement, path, options.tolerances, rows);
  check_jumps(*world.robot, path, options.jump_threshold, rows);
  return rows.join(path.demonstration_time);
}

}  // namespace morphe::check
