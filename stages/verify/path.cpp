#include "stages/verify/path.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kPathTimeTolerance_s = 1e-9, kMappedPositionTolerance = 1e-9;
constexpr double kMaxPathDeviation_rad = 0.2, kMaxPathDeviation_m = 0.1;

bool is_prismatic_joint(const RobotModel& robot, Eigen::Index joint) {
  const auto first =
      std::ranges::find(robot.frames, static_cast<int>(joint), &RobotModel::Frame::joint);
  return first != robot.frames.end() && first->prismatic;
}

bool is_nondecreasing(const std::vector<double>& time) {
  return std::ranges::all_of(time, [](double t) { return std::isfinite(t); }) &&
         std::ranges::is_sorted(time);
}

void verify_mapped_samples(const Plan& plan, ViolationCollector& runs) {
  const JointPath& path = plan.path;
  const JointRows& mapped = plan.mapped.position;
  if (mapped.rows() != static_cast<Eigen::Index>(plan.goals.frames())) return;
  double worst = 0;
  for (std::size_t i = 0; i < path.origin.size(); ++i) {
    if (path.origin[i] != SampleOrigin::mapped) continue;
    const GoalInterpolation at = interpolate_goal_frames(plan.goals, path.demonstration_time[i]);
    const auto before = static_cast<Eigen::Index>(at.before);
    const auto after = static_cast<Eigen::Index>(at.after);
    const auto own = (1 - at.share) * mapped.row(before) + at.share * mapped.row(after);
    const double off = (path.position.row(i) - own).cwiseAbs().maxCoeff();
    worst = off <= worst ? worst : off;
  }
  if (!(worst <= kMappedPositionTolerance))
    runs.note_plan("path", "position", worst, kMappedPositionTolerance);
}

/// The rows of the path around a time: those at the time, and the nearest on either side.
struct NeighbourRows {
  std::size_t first = 0, last = 0;
};

NeighbourRows neighbour_rows(const std::vector<double>& time, double time_s) {
  const auto low = std::ranges::lower_bound(time, time_s - kPathTimeTolerance_s);
  const auto high = std::ranges::upper_bound(time, time_s + kPathTimeTolerance_s);
  const auto first = static_cast<std::size_t>(low - time.begin());
  const auto after = static_cast<std::size_t>(high - time.begin());
  return {first == 0 ? 0 : first - 1, std::min(after, time.size() - 1)};
}

void verify_trajectory_near_path(const RobotModel& robot, const Plan& plan,
                                 ViolationCollector& runs) {
  const JointPath& path = plan.path;
  const Trajectory& trajectory = plan.trajectory;
  JointVector most(trajectory.position.cols());
  for (Eigen::Index j = 0; j < most.size(); ++j)
    most(j) = is_prismatic_joint(robot, j) ? kMaxPathDeviation_m : kMaxPathDeviation_rad;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const NeighbourRows rows =
        neighbour_rows(path.demonstration_time, trajectory.demonstration_time[sample]);
    const auto block = path.position.middleRows(rows.first, (rows.last - rows.first) + 1);
    const CurvePoint place{static_cast<int>(2 * sample), static_cast<int>(sample),
                           trajectory.time[sample]};
    for (Eigen::Index j = 0; j < most.size(); ++j) {
      const double q = trajectory.position(sample, j);
      const double off = std::max(block.col(j).minCoeff() - q, q - block.col(j).maxCoeff());
      if (!(off <= most(j))) runs.note("path", "trajectory", place, off, most(j), off);
    }
    bool there = false;
    for (std::size_t i = rows.first; i <= rows.last; ++i)
      there = there || path.origin[i] == trajectory.origin[sample];
    if (!there)
      runs.note("path", "origin", place, static_cast<double>(trajectory.origin[sample]),
                static_cast<double>(path.origin[rows.first]), 0);
  }
}

}  // namespace

void verify_path(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const JointPath& path = plan.path;
  const std::vector<double>& time = path.demonstration_time;
  if (time.empty() || plan.goals.frames() == 0 || !is_nondecreasing(time)) {
    runs.note_plan("path", "demonstration_time", static_cast<double>(time.size()), 1);
    return;
  }
  if (!path.position.allFinite()) {
    runs.note_plan("path", "position", kUnknown, kUnknown);
    return;
  }
  for (const auto& [own, goal] : {std::pair(time.front(), plan.goals.time.front()),
                                  std::pair(time.back(), plan.goals.time.back())}) {
    if (!(std::abs(own - goal) <= kPathTimeTolerance_s))
      runs.note_plan("path", "demonstration_time", own, goal);
  }
  verify_mapped_samples(plan, runs);
  verify_trajectory_near_path(robot, plan, runs);
}

}  // namespace morphe::verify
