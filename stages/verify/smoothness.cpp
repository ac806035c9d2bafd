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

bool has_goal_throughout(const Goals& goals, std::size_t tip) {
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    if (!goals.tip_position(f, tip).allFinite()) return false;
  }
  return true;
}

/// Adds the speed of one tip: speed[k - 1] += |points[k + 1] - points[k - 1]| / 2h / tips.
void add_speed(const std::vector<Vec3>& points, double step_s, std::size_t tips,
               std::vector<double>& speed) {
  if (points.size() < 3) return;
  speed.resize(points.size() - 2, 0.0);
  for (std::size_t k = 0; k + 2 < points.size(); ++k) {
    speed[k] += (points[k + 2] - points[k]).norm() / (2 * step_s * static_cast<double>(tips));
  }
}

/// Passes the joint positions of the curve at the instants k h to `take`, in order.
template <class Take>
void positions_at(const Curve& curve, double step_s, const Take& take) {
  const std::vector<double>& time = curve.trajectory->time;
  JointVector position;
  std::size_t piece = 0;
  for (std::size_t k = 0;; ++k) {
    const double t = time.front() + static_cast<double>(k) * step_s;
    if (t > time.back() + 1e-9 * step_s) return;
    while (piece + 1 < curve.pieces && time[piece + 1] <= t) ++piece;
    const double share = (t - time[piece]) / (time[piece + 1] - time[piece]);
    curve.position_at(piece, std::min(share, 1.0), position);
    take(position);
  }
}

using Complex = std::complex<double>;

/// Returns e^(-2 pi i share).
Complex twiddle_factor(double share) { return std::polar(1.0, -2 * std::numbers::pi * share); }

constexpr std::size_t kZeroPaddingRatio = 16;

/// Returns the magnitudes of the spectrum of the speed, padded with zeros to kZeroPaddingRatio
/// times the least power of two that contains it. Every kZeroPaddingRatio-th magnitude comes from
/// one transform, of the speed multiplied by a twiddle factor.
std::vector<double> spectrum(const std::vector<double>& speed) {
  const std::size_t size = std::bit_ceil(speed.size()), padded = kZeroPaddingRatio * size;
  std::vector<double> magnitude(padded);
  Eigen::FFT<double> transform;
  std::vector<Complex> turned_speed(size), x;
  for (std::size_t first = 0; first < kZeroPaddingRatio; ++first) {
    for (std::size_t i = 0; i < speed.size(); ++i)
      turned_speed[i] =
          speed[i] * twiddle_factor(static_cast<double>(first * i) / static_cast<double>(padded));
    transform.fwd(x, turned_speed);
    for (std::size_t k = 0; k < size; ++k)
      magnitude[kZeroPaddingRatio * k + first] = std::abs(x[k]);
  }
  return magnitude;
}

bool is_motion(const std::vector<double>& speed, double step_s) {
  return speed.size() >= 3 && step_s > 0 &&
         std::any_of(speed.begin(), speed.end(), [](double v) { return v > 0; });
}

}  // namespace

Speeds mean_speeds(const RobotModel& robot, const Goals& goals, const Curve& curve) {
  Speeds speeds;
  if (goals.frames() < 2) return speeds;
  speeds.step_s =
      (goals.time.back() - goals.time.front()) / static_cast<double>(goals.frames() - 1);
  std::vector<std::size_t> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (has_goal_throughout(goals, tip)) tips.push_back(tip);
  }
  if (tips.empty() || !(speeds.step_s > 0)) return speeds;
  std::vector<std::vector<Vec3>> robots(tips.size());
  std::vector<Pose> poses;
  positions_at(curve, speeds.step_s, [&](const JointVector& q) {
    frame_poses(robot, q, poses);
    for (std::size_t k = 0; k < tips.size(); ++k) {
      const RobotModel::Tip& which = robot.tips[tips[k]];
      robots[k].push_back(to_base_frame(poses, which.frame, which.transform.translation()));
    }
  });
  for (std::size_t k = 0; k < tips.size(); ++k) {
    std::vector<Vec3> humans;
    for (std::size_t f = 0; f < goals.frames(); ++f)
      humans.push_back(goals.tip_position(f, tips[k]));
    add_speed(robots[k], speeds.step_s, tips.size(), speeds.robot);
    add_speed(humans, speeds.step_s, tips.size(), speeds.human);
  }
  return speeds;
}

double sparc(const std::vector<double>& speed, double step_s) {
  if (!is_motion(speed, step_s)) return kUnknown;
  std::vector<double> magnitude = spectrum(speed);
  const double per_hz = static_cast<double>(magnitude.size()) * step_s;
  const double up_to_10_hz = std::floor(10 * (1 + 1e-12) * per_hz);
  if (up_to_10_hz + 1 < static_cast<double>(magnitude.size()))
    magnitude.resize(static_cast<std::size_t>(up_to_10_hz) + 1);
  const double greatest = *std::max_element(magnitude.begin(), magnitude.end());
  const auto above = std::find_if(magnitude.rbegin(), magnitude.rend(),
                                  [&](double m) { return m >= 0.05 * greatest; });
  magnitude.erase(above.base(), magnitude.end());
  if (magnitude.size() < 2) return kUnknown;
  const double bin = 1 / static_cast<double>(magnitude.size() - 1);
  double length = 0;
  for (std::size_t k = 1; k < magnitude.size(); ++k) {
    const double rise = (magnitude[k] - magnitude[k - 1]) / greatest;
    length += std::sqrt(bin * bin + rise * rise);
  }
  return -length;
}

double log_dimensionless_jerk(const std::vector<double>& speed, double step_s) {
  if (!is_motion(speed, step_s)) return kUnknown;
  double sum = 0;
  for (std::size_t i = 2; i < speed.size(); ++i) {
    const double bend = (speed[i] - speed[i - 1]) - (speed[i - 1] - speed[i - 2]);
    sum += bend * bend;
  }
  // With time in units of the step, the factor is duration^3 / step^3.
  const double steps = static_cast<double>(speed.size() - 1);
  const double peak = *std::max_element(speed.begin(), speed.end());
  return -(3 * std::log(steps) + std::log(sum) - 2 * std::log(peak));
}

}  // namespace morphe::verify
