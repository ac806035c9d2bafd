#include "pipeline/study/score_timing.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::study {
namespace {

/// Computes the speed of a point in each frame, NaN if a position that it depends on is unknown.
std::vector<double> speeds(const std::vector<double>& time, const std::vector<Vec3>& position) {
  const std::ptrdiff_t count = std::ssize(time);
  std::vector<double> raw(count, kUnknown), mean = raw;
  for (int f = 1; f + 1 < count; ++f)
    raw[f] = (position[f + 1] - position[f - 1]).norm() / (time[f + 1] - time[f - 1]);
  for (int f = 2; f + 2 < count; ++f)
    mean[f] = (raw[f - 2] + raw[f - 1] + raw[f] + raw[f + 1] + raw[f + 2]) / 5;
  return mean;
}

/// Returns the joint positions at a time, by cubic interpolation between samples.
JointVector position_at(const Trajectory& t, double time_s) {
  const auto after = std::ranges::upper_bound(t.time, time_s);
  const Eigen::Index last = t.position.rows() - 1;
  const Eigen::Index i = std::clamp<Eigen::Index>(after - t.time.begin() - 1, 0, last - 1);
  const double begin_s = t.time[i];
  const double h = t.time[i + 1] - begin_s;
  const double z = std::clamp((time_s - begin_s) / h, 0.0, 1.0);
  const double back = 1 - z;
  return (back * back * (1 + 2 * z) * t.position.row(i) +
          z * z * (1 + 2 * back) * t.position.row(i + 1) +
          h * z * back * (back * t.velocity.row(i) - z * t.velocity.row(i + 1)))
      .transpose();
}

}  // namespace

TimingScore score_timing(const RobotModel& robot, const Goals& goals, const Trajectory& t) {
  TimingScore score;
  if (t.samples() < 2 || goals.frames() < 2) return score;
  const double human_s = t.demonstration_time.back() - t.demonstration_time.front();
  score.duration_ratio = t.time.back() / human_s;
  constexpr int kHalfWindow = 5;  // samples on each side over which the speed ratio is computed
  int at_human_speed = 0, all = 0;
  for (int i = kHalfWindow; i + kHalfWindow < std::ssize(t.time); ++i, ++all) {
    const double speed_ratio =
        (t.demonstration_time[i + kHalfWindow] - t.demonstration_time[i - kHalfWindow]) /
        (t.time[i + kHalfWindow] - t.time[i - kHalfWindow]);
    at_human_speed += std::abs(speed_ratio - 1) < 0.03 ? 1 : 0;
  }
  score.human_speed_share = at_human_speed / static_cast<double>(all);
  std::vector<std::vector<Pose>> frames(goals.frames());
  for (int f = 0; f < std::ssize(frames); ++f)
    robot::forward_kinematics(robot, position_at(t, goals.time[f] - t.demonstration_time.front()),
                              frames[f]);
  std::vector<double> robot_speeds, human_speeds;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    std::vector<Vec3> robot_tip, human_tip;
    for (int f = 0; f < std::ssize(frames); ++f) {
      robot_tip.push_back(robot::tip_pose(robot, frames[f], tip).translation());
      human_tip.push_back(goals.tip_position(f, tip));
    }
    const std::vector<double> robot_speed = speeds(goals.time, robot_tip);
    const std::vector<double> human_speed = speeds(goals.time, human_tip);
    for (int f = 0; f < std::ssize(robot_speed); ++f) {
      if (!std::isfinite(robot_speed[f]) || !std::isfinite(human_speed[f])) continue;
      robot_speeds.push_back(robot_speed[f]);
      human_speeds.push_back(human_speed[f]);
    }
  }
  score.correlation = math::correlation(robot_speeds, human_speeds);
  return score;
}

}  // namespace morphe::study
