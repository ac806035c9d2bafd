#include "pipeline/report/select_display_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/quintic.hpp"

namespace morphe::report {
namespace {

/// Returns the row with the greatest |value| in a column; NaN is never selected.
int greatest_row(const JointRows& values, Eigen::Index column) {
  Eigen::Index best = 0;
  for (Eigen::Index row = 1; row < values.rows(); ++row) {
    if (std::abs(values(row, column)) > std::abs(values(best, column))) best = row;
  }
  return static_cast<int>(best);
}

}  // namespace

JointRows jerk_ratios(const RobotModel& robot, const Trajectory& trajectory) {
  const Eigen::Index joints = trajectory.position.cols();
  const auto samples = static_cast<Eigen::Index>(trajectory.samples());
  JointRows shares = JointRows::Zero(std::max<Eigen::Index>(samples - 1, 0), joints);
  for (Eigen::Index row = 0; row < shares.rows(); ++row) {
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      const math::Range jerk = math::extremes(math::quintic_piece(trajectory, row, joint)).jerk;
      const double greatest = jerk.greatest > -jerk.least ? jerk.greatest : jerk.least;
      shares(row, joint) = greatest / robot.jerk[joint];
    }
  }
  return shares;
}

std::vector<int> select_display_rows(const RobotModel& robot, const Trajectory& trajectory,
                                     double rate_hz) {
  const auto samples = static_cast<int>(trajectory.samples());
  if (samples == 0) return {};
  std::set<int> rows{0, samples - 1};
  double next_s = trajectory.time.front() + 1 / rate_hz;
  for (int row = 1; row < samples; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const bool too_late = row + 1 < samples && trajectory.time[i + 1] > next_s + 1e-9;
    if (!too_late && trajectory.time[i] < next_s - 1e-9) continue;
    rows.insert(row);
    next_s = trajectory.time[i] + 1 / rate_hz;
  }
  if (samples > 1) {
    const JointRows jerk = jerk_ratios(robot, trajectory);
    for (Eigen::Index joint = 0; joint < jerk.cols(); ++joint) {
      rows.insert(greatest_row(trajectory.velocity, joint));
      rows.insert(greatest_row(trajectory.acceleration, joint));
      rows.insert(greatest_row(jerk, joint));
      Eigen::Index least = 0, most = 0;
      trajectory.position.col(joint).minCoeff(&least);
      trajectory.position.col(joint).maxCoeff(&most);
      rows.insert({static_cast<int>(least), static_cast<int>(most)});
    }
  }
  const auto least = std::ranges::min_element(trajectory.clearance);
  if (least != trajectory.clearance.end() && !std::isnan(*least))
    rows.insert(static_cast<int>(least - trajectory.clearance.begin()));
  return {rows.begin(), rows.end()};
}

}  // namespace morphe::report
