#include "stages/verify/path.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kPathTime_s = 1e-9, kSame = 1e-9;
constexpr double kAside_rad = 0.2, kAside_m = 0.1;

bool slides(const RobotTable& robot, Eigen::Index joint) {
  const auto first =
      std::ranges::find(robot.frames, static_cast<int>(joint), &RobotTable::Frame::joint);
  return first != robot.frames.end() && first->slides;
}

bool runs_on(const std::vector<double>& time) {
  return std::ranges::all_of(time, [](double t) { return std::isfinite(t); }) &&
         std::ranges::is_sorted(time);
}

void judge_mapped_samples(const Plan& plan, ViolationRuns& runs) {
  const JointPath& path = plan.path;
  const JointRows& mapped = plan.mapped.position;
  if (mapped.rows() != static_cast<Eigen::Index>(plan.goals.frames())) return;
  double worst = 0;
  for (std::size_t i = 0; i < path.origin.size(); ++i) {
    if (path.origin[i] != Origin::mapped) continue;
    const GoalShare at = goal_share(plan.goals, path.demonstration_time[i]);
    const auto before = static_cast<Eigen::Index>(at.before);
    const auto after = static_cast<Eigen::Index>(at.after);
    const auto own = (1 - at.share) * mapped.row(before) + at.share * mapped.row(after);
    const double off =
        (path.position.row(static_cast<Eigen::Index>(i)) - own).cwiseAbs().maxCoeff();
    worst = off <= worst ? worst : off;
  }
  if (!(worst <= kSame)) runs.note_plan("path", "position", worst, kSame);
}

/// Rows of the path around a time: those at it, and the nearest on either side.
struct Around {
  std::size_t first = 0, last = 0;
};

Around around(const std::vector<double>& time, double time_s) {
  const auto low = std::ranges::lower_bound(time, time_s - kPathTime_s);
  const auto high = std::ranges::upper_bound(time, time_s + kPathTime_s);
  const auto first = static_cast<std::size_t>(low - time.begin());
  const auto after = static_cast<std::size_t>(high - time.begin());
  return {first == 0 ? 0 : first - 1, std::min(after, time.size() - 1)};
}

void judge_trajectory(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const JointPath& path = plan.path;
  const Trajectory& trajectory = plan.trajectory;
  JointVector most(trajectory.position.cols());
  for (Eigen::Index j = 0; j < most.size(); ++j) most(j) = slides(robot, j) ? kAside_m : kAside_rad;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const Around rows = around(path.demonstration_time, trajectory.demonstration_time[sample]);
    const auto block =
        path.position.middleRows(static_cast<Eigen::Index>(rows.first),
                                 static_cast<Eigen::Index>(rows.last - rows.first) + 1);
    const CurvePoint place{static_cast<int>(2 * sample), static_cast<int>(sample),
                           trajectory.time[sample]};
    for (Eigen::Index j = 0; j < most.size(); ++j) {
      const double q = trajectory.position(static_cast<Eigen::Index>(sample), j);
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

void judge_path(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const JointPath& path = plan.path;
  const std::vector<double>& time = path.demonstration_time;
  if (time.empty() || plan.goals.frames() == 0 || !runs_on(time)) {
    runs.note_plan("path", "demonstration_time", static_cast<double>(time.size()), 1);
    return;
  }
  if (!path.position.allFinite()) {
    runs.note_plan("path", "position", kNotSeen, kNotSeen);
    return;
  }
  for (const auto& [own, goal] : {std::pair(time.front(), plan.goals.time.front()),
                                  std::pair(time.back(), plan.goals.time.back())}) {
    if (!(std::abs(own - goal) <= kPathTime_s))
      runs.note_plan("path", "demonstration_time", own, goal);
  }
  judge_mapped_samples(plan, runs);
  judge_trajectory(robot, plan, runs);
}

}  // namespace morphe::verify
