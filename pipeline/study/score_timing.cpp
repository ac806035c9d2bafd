#include "pipeline/study/score_timing.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/study/correlation.hpp"

namespace morphe::study {
namespace {

/// Computes the speed of a point over frames as a mean over five values, NaN if one of nine
/// positions is unknown.
std::vector<double> speeds(const std::vector<double>& time, const std::vector<Vec3>& position) {
  std::vector<double> raw(time.size(), kUnknown), out = raw;
  for (std::size_t f = 1; f + 1 < time.size(); ++f) {
    raw[f] = (position[f + 1] - position[f - 1]).norm() / (time[f + 1] - time[f - 1]);
  }
  for (std::size_t f = 2; f + 2 < time.size(); ++f) {
    out[f] = (raw[f - 2] + raw[f - 1] + raw[f] + raw[f + 1] + raw[f + 2]) / 5;
  }
  return out;
}

/// Returns the joint positions at a time by interpolation between samples.
JointVector position_at(const Trajectory& t, double time_s) {
  const auto after = std::upper_bound(t.time.begin(), t.time.end(), time_s);
  const auto last = static_cast<Eigen::Index>(t.samples()) - 1;
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
  TimingScore out;
  if (t.samples() < 2 || goals.frames() < 2) return out;
  const double human_s = t.demonstration_time.back() - t.demonstration_time.front();
  out.duration_ratio = t.time.back() / human_s;
  constexpr std::size_t kHalfWindowSamples =
      5;  ///< samples on each side over which the pace is computed
  std::size_t human = 0, all = 0;
  for (std::size_t i = kHalfWindowSamples; i + kHalfWindowSamples < t.samples(); ++i, ++all) {
    const double pace = (t.demonstration_time[i + kHalfWindowSamples] -
                         t.demonstration_time[i - kHalfWindowSamples]) /
                        (t.time[i + kHalfWindowSamples] - t.time[i - kHalfWindowSamples]);
    human += std::abs(pace - 1) < 0.03;
  }
  out.human_speed_share = static_cast<double>(human) / static_cast<double>(all);
  std::vector<std::vector<Pose>> frames(goals.frames());
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    robot::forward_kinematics(robot, position_at(t, goals.time[f] - t.demonstration_time.front()),
                              frames[f]);
  }
  std::vector<double> ours, theirs;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    std::vector<Vec3> robots, humans;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      robots.push_back(robot::tip_pose(robot, frames[f], tip).translation());
      humans.push_back(goals.tip_position(f, tip));
    }
    const std::vector<double> a = speeds(goals.time, robots), b = speeds(goals.time, humans);
    for (std::size_t f = 0; f < a.size(); ++f) {
      if (!std::isfinite(a[f]) || !std::isfinite(b[f])) continue;
      ours.push_back(a[f]);
      theirs.push_back(b[f]);
    }
  }
  out.correlation = correlation(ours, theirs);
  return out;
}

}  // namespace morphe::study
