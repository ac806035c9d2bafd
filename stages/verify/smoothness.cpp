#include "stages/verify/smoothness.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

bool has_goal_throughout(const Goals& goals, int tip) {
  int frame = 0;
  while (frame < std::ssize(goals.time) && is_known(goals.tip_position(frame, tip))) ++frame;
  return frame == std::ssize(goals.time);
}

/// Adds the speed of one of the tips: speed[k] += |points[k + 2] - points[k]| / 2h / tips.
void add_speed(const std::vector<Vec3>& points, double step_s, std::size_t tips,
               std::vector<double>& speed) {
  if (points.size() < 3) return;
  speed.resize(points.size() - 2, 0.0);
  for (int k = 0; k < std::ssize(speed); ++k)
    speed[k] += (points[k + 2] - points[k]).norm() / (2 * step_s * static_cast<double>(tips));
}

/// Passes the joint positions of the curve at the instants k step_s to `visit`, in order.
template <class Take>
void visit_positions(const Curve& curve, double step_s, const Take& visit) {
  const std::vector<double>& time = curve.trajectory->time;
  JointVector position;
  int piece = 0;
  for (int k = 0;; ++k) {
    const double time_s = time.front() + k * step_s;
    if (time_s > time.back() + 1e-9 * step_s) return;
    while (piece + 1 < curve.pieces && time[piece + 1] <= time_s) ++piece;
    const double share = (time_s - time[piece]) / (time[piece + 1] - time[piece]);
    curve.position_at(piece, std::min(share, 1.0), position);
    visit(position);
  }
}

using Complex = std::complex<double>;

constexpr std::size_t kZeroPaddingRatio = 16;

/// Returns the magnitudes of the spectrum of the speed, padded with zeros to kZeroPaddingRatio
/// times the least power of two that contains it. Every kZeroPaddingRatio-th magnitude comes from
/// one transform, of the speed multiplied by e^(-2 pi i share).
std::vector<double> spectrum(const std::vector<double>& speed) {
  const std::size_t size = std::bit_ceil(speed.size()), padded = kZeroPaddingRatio * size;
  std::vector<double> magnitude(padded);
  Eigen::FFT<double> transform;
  std::vector<Complex> modulated_speed(size), x;
  for (std::size_t first = 0; first < kZeroPaddingRatio; ++first) {
    for (std::size_t i = 0; i < speed.size(); ++i) {
      const double share = static_cast<double>(first * i) / static_cast<double>(padded);
      modulated_speed[i] = speed[i] * std::polar(1.0, -2 * std::numbers::pi * share);
    }
    transform.fwd(x, modulated_speed);
    for (std::size_t k = 0; k < size; ++k)
      magnitude[kZeroPaddingRatio * k + first] = std::abs(x[k]);
  }
  return magnitude;
}

bool is_motion(const std::vector<double>& speed, double step_s) {
  return speed.size() >= 3 && step_s > 0 &&
         std::ranges::any_of(speed, [](double v) { return v > 0; });
}

}  // namespace

Speeds mean_speeds(const RobotModel& robot, const Goals& goals, const Curve& curve) {
  Speeds speeds;
  if (goals.frames() < 2) return speeds;
  speeds.step_s =
      (goals.time.back() - goals.time.front()) / static_cast<double>(goals.frames() - 1);
  std::vector<int> tips;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip)
    if (has_goal_throughout(goals, tip)) tips.push_back(tip);
  if (tips.empty() || !(speeds.step_s > 0)) return speeds;
  std::vector<std::vector<Vec3>> robot_points(tips.size());
  std::vector<Pose> poses;
  visit_positions(curve, speeds.step_s, [&](const JointVector& q) {
    frame_poses(robot, q, poses);
    for (int k = 0; k < std::ssize(tips); ++k) {
      const RobotModel::Tip& tip = robot.tips[tips[k]];
      robot_points[k].push_back(to_base_frame(poses, tip.frame, tip.transform.translation()));
    }
  });
  for (int k = 0; k < std::ssize(tips); ++k) {
    std::vector<Vec3> goal_points;
    for (int f = 0; f < std::ssize(goals.time); ++f)
      goal_points.push_back(goals.tip_position(f, tips[k]));
    add_speed(robot_points[k], speeds.step_s, tips.size(), speeds.robot);
    add_speed(goal_points, speeds.step_s, tips.size(), speeds.human);
  }
  return speeds;
}

double sparc(const std::vector<double>& speed, double step_s) {
  if (!is_motion(speed, step_s)) return kUnknown;
  std::vector<double> magnitude = spectrum(speed);
  const double index_per_hz = static_cast<double>(magnitude.size()) * step_s;
  const double last_index = std::floor(10 * (1 + 1e-12) * index_per_hz);
  if (last_index + 1 < static_cast<double>(magnitude.size()))
    magnitude.resize(static_cast<std::size_t>(last_index) + 1);
  const double greatest = *std::ranges::max_element(magnitude);
  while (!magnitude.empty() && !(magnitude.back() >= 0.05 * greatest)) magnitude.pop_back();
  if (magnitude.size() < 2) return kUnknown;
  const double frequency_step = 1 / static_cast<double>(magnitude.size() - 1);
  double length = 0;
  for (int k = 1; k < std::ssize(magnitude); ++k) {
    const double rise = (magnitude[k] - magnitude[k - 1]) / greatest;
    length += std::sqrt(frequency_step * frequency_step + rise * rise);
  }
  return -length;
}

double log_dimensionless_jerk(const std::vector<double>& speed, double step_s) {
  if (!is_motion(speed, step_s)) return kUnknown;
  double sum = 0;
  for (int i = 2; i < std::ssize(speed); ++i) {
    const double difference = (speed[i] - speed[i - 1]) - (speed[i - 1] - speed[i - 2]);
    sum += difference * difference;
  }
  // With time in units of the step, the factor is duration^3 / step^3.
  const double steps = static_cast<double>(speed.size() - 1);
  const double peak = *std::ranges::max_element(speed);
  return -(3 * std::log(steps) + std::log(sum) - 2 * std::log(peak));
}

}  // namespace morphe::verify
