#include "stages/verify/path.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/find_index.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kPathTimeTolerance_s = 1e-9, kMappedPositionTolerance = 1e-9;
constexpr double kMaxPathDeviation_rad = 0.2, kMaxPathDeviation_m = 0.1;

bool is_prismatic_joint(const RobotModel& robot, int joint) {
  const int frame = find_index(robot.frames, joint, &RobotModel::Frame::joint);
  return frame >= 0 && robot.frames[frame].prismatic;
}

bool is_nondecreasing(const std::vector<double>& time) {
  return std::ranges::all_of(time, [](double time_s) { return std::isfinite(time_s); }) &&
         std::ranges::is_sorted(time);
}

void verify_mapped_samples(const Plan& plan, ViolationLog& violations) {
  const JointPath& path = plan.path;
  const JointRows& mapped = plan.mapped.position;
  if (mapped.rows() != std::ssize(plan.goals.time)) return;
  double max_deviation = 0;
  for (int i = 0; i < std::ssize(path.origin); ++i) {
    if (path.origin[i] != SampleOrigin::mapped) continue;
    const GoalInterpolation mix = interpolate_goal_frames(plan.goals, path.demonstration_time[i]);
    const auto own = (1 - mix.share) * mapped.row(mix.before) + mix.share * mapped.row(mix.after);
    const double deviation = (path.position.row(i) - own).cwiseAbs().maxCoeff();
    max_deviation = deviation <= max_deviation ? max_deviation : deviation;
  }
  if (!(max_deviation <= kMappedPositionTolerance))
    violations.note_plan("path", "position", max_deviation, kMappedPositionTolerance);
}

/// The first and the last row of the path around a time: those at it, and one more on either side.
struct NeighbourRows {
  std::ptrdiff_t first = 0, last = 0;
};

NeighbourRows neighbour_rows(const std::vector<double>& time, double time_s) {
  const auto first = std::ranges::lower_bound(time, time_s - kPathTimeTolerance_s);
  const auto after = std::ranges::upper_bound(time, time_s + kPathTimeTolerance_s);
  return {std::max(first - time.begin() - 1, std::ptrdiff_t{0}),
          std::min(after - time.begin(), std::ssize(time) - 1)};
}

void verify_trajectory_near_path(const RobotModel& robot, const Plan& plan,
                                 ViolationLog& violations) {
  const JointPath& path = plan.path;
  const Trajectory& trajectory = plan.trajectory;
  JointVector limits(trajectory.position.cols());
  for (int j = 0; j < limits.size(); ++j)
    limits(j) = is_prismatic_joint(robot, j) ? kMaxPathDeviation_m : kMaxPathDeviation_rad;
  for (int sample = 0; sample < std::ssize(trajectory.time); ++sample) {
    const auto [first, last] =
        neighbour_rows(path.demonstration_time, trajectory.demonstration_time[sample]);
    const auto rows = path.position.middleRows(first, (last - first) + 1);
    const CurvePoint point = point_at_sample(trajectory, sample);
    for (Eigen::Index j = 0; j < limits.size(); ++j) {
      const double q = trajectory.position(sample, j);
      const double excess = std::max(rows.col(j).minCoeff() - q, q - rows.col(j).maxCoeff());
      if (!(excess <= limits(j)))
        violations.note("path", "trajectory", point, excess, limits(j), excess);
    }
    const SampleOrigin origin = trajectory.origin[sample];
    const auto begin = path.origin.begin() + first, end = path.origin.begin() + last + 1;
    if (std::find(begin, end, origin) == end)
      violations.note("path", "origin", point, static_cast<double>(origin),
                      static_cast<double>(*begin), 0);
  }
}

}  // namespace

void verify_path(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const JointPath& path = plan.path;
  const std::vector<double>& time = path.demonstration_time;
  if (time.empty() || plan.goals.frames() == 0 || !is_nondecreasing(time)) {
    violations.note_plan("path", "demonstration_time", static_cast<double>(time.size()), 1);
    return;
  }
  if (!path.position.allFinite()) {
    violations.note_plan("path", "position", kUnknown, kUnknown);
    return;
  }
  for (const auto& [own, goal] : {std::pair(time.front(), plan.goals.time.front()),
                                  std::pair(time.back(), plan.goals.time.back())}) {
    if (!(std::abs(own - goal) <= kPathTimeTolerance_s))
      violations.note_plan("path", "demonstration_time", own, goal);
  }
  verify_mapped_samples(plan, violations);
  verify_trajectory_near_path(robot, plan, violations);
}

}  // namespace morphe::verify
