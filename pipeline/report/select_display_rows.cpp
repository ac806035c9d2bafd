#include "pipeline/report/select_display_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/quintic.hpp"

namespace morphe::report {
namespace {

/// Returns the row with the greatest |value| in a column.
int row_of_max_magnitude(const JointRows& values, Eigen::Index column) {
  int row_of_max = 0;
  for (int row = 1; row < values.rows(); ++row) {
    if (std::abs(values(row, column)) > std::abs(values(row_of_max, column))) row_of_max = row;
  }
  return row_of_max;
}

}  // namespace

JointRows jerk_ratios(const RobotModel& robot, const Trajectory& trajectory) {
  const Eigen::Index joints = trajectory.position.cols();
  const Eigen::Index samples = std::ssize(trajectory.time);
  JointRows ratios = JointRows::Zero(std::max<Eigen::Index>(samples - 1, 0), joints);
  for (Eigen::Index row = 0; row < ratios.rows(); ++row) {
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      const math::Range jerk = math::extremes(math::quintic_piece(trajectory, row, joint)).jerk;
      const double peak = jerk.greatest > -jerk.least ? jerk.greatest : jerk.least;
      ratios(row, joint) = peak / robot.jerk[joint];
    }
  }
  return ratios;
}

std::vector<int> select_display_rows(const RobotModel& robot, const Trajectory& trajectory,
                                     double rate_hz) {
  const std::vector<double>& time = trajectory.time;
  if (time.empty()) return {};
  const std::ptrdiff_t last = std::ssize(time) - 1;
  std::set<int> rows;
  double next_s = time.front();
  for (int row = 0; row <= last; ++row) {
    const bool inner = row > 0 && row < last;
    const bool next_is_late = inner && time[row + 1] > next_s + 1e-9;
    if (inner && !next_is_late && time[row] < next_s - 1e-9) continue;
    rows.insert(row);
    next_s = time[row] + 1 / rate_hz;
  }
  if (last > 0) {
    const JointRows jerk = jerk_ratios(robot, trajectory);
    for (Eigen::Index joint = 0; joint < jerk.cols(); ++joint) {
      rows.insert(row_of_max_magnitude(trajectory.velocity, joint));
      rows.insert(row_of_max_magnitude(trajectory.acceleration, joint));
      rows.insert(row_of_max_magnitude(jerk, joint));
      int row_of_min = 0, row_of_max = 0;
      trajectory.position.col(joint).minCoeff(&row_of_min);
      trajectory.position.col(joint).maxCoeff(&row_of_max);
      rows.insert({row_of_min, row_of_max});
    }
  }
  const std::vector<double>& clearance = trajectory.clearance;
  int closest = 0;
  for (int row = 1; row < std::ssize(clearance); ++row) {
    if (clearance[row] < clearance[closest]) closest = row;
  }
  if (!clearance.empty() && !std::isnan(clearance[closest])) rows.insert(closest);
  return {rows.begin(), rows.end()};
}

}  // namespace morphe::report
