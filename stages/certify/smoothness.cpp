#include "stages/certify/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/robot/forward_kinematics.hpp"
#include "stages/certify/trajectory_motion.hpp"

namespace morphe::certify {
namespace {

std::vector<std::size_t> tips_always_seen(const Goals& goals) {
  std::vector<std::size_t> tips;
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
    bool always = goals.frames() > 0;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      always = always && is_known(goals.tip_position(f, tip));
    }
    if (always) tips.push_back(tip);
  }
  return tips;
}

double step_of(const Goals& goals) {
  if (goals.frames() < 2) return 0;
  return (goals.time.back() - goals.time.front()) / static_cast<double>(goals.frames() - 1);
}

/// Computes the mean speed; positions[k] are all points at instant k.
SpeedProfile central_differences(const std::vector<std::vector<Vec3>>& positions, double step_s) {
  SpeedProfile profile{{}, step_s};
  for (int k = 1; k + 1 < std::ssize(positions); ++k) {
    double sum = 0;
    for (int i = 0; i < std::ssize(positions[k]); ++i) {
      sum += (positions[k + 1][i] - positions[k - 1][i]).norm() / (2 * step_s);
    }
    profile.speed.push_back(sum / static_cast<double>(positions[k].size()));
  }
  return profile;
}

bool moves(const SpeedProfile& profile) {
  return profile.speed.size() >= 3 && profile.step_s > 0 && std::ranges::max(profile.speed) > 0;
}

/// Returns |sum_i v_i e^(-j angle i)|.
double spectrum_at(const std::vector<double>& speed, double angle) {
  // Horner's scheme for the polynomial in e^(-j angle).
  const double c = std::cos(angle), s = std::sin(angle);
  double re = 0, im = 0;
  for (std::ptrdiff_t i = std::ssize(speed) - 1; i >= 0; --i) {
    const double next_re = re * c + im * s + speed[i];
    im = im * c - re * s;
    re = next_re;
  }
  return std::hypot(re, im);
}

}  // namespace

SpeedProfile robot_speed(const RobotModel& robot, const Goals& goals,
                         const Trajectory& trajectory) {
  const std::vector<std::size_t> tips = tips_always_seen(goals);
  const double step_s = step_of(goals);
  if (tips.empty() || !(step_s > 0) || trajectory.samples() < 2) return {};
  const collision::JointMotion motion = trajectory_motion(trajectory);
  const double steps = (motion.end - motion.begin) / step_s * (1 + 1e-12) + 1e-9;
  std::vector<std::vector<Vec3>> positions(std::lround(std::floor(steps)) + 1);
  std::vector<Pose> base_from_frame;
  JointVector q;
  for (std::ptrdiff_t k = 0; k < std::ssize(positions); ++k) {
    motion.position(std::min(motion.begin + static_cast<double>(k) * step_s, motion.end), q);
    robot::forward_kinematics(robot, q, base_from_frame);
    for (const std::size_t tip : tips) {
      positions[k].push_back(robot::tip_pose(robot, base_from_frame, tip).translation());
    }
  }
  return central_differences(positions, step_s);
}

SpeedProfile human_speed(const Goals& goals) {
  const std::vector<std::size_t> tips = tips_always_seen(goals);
  if (tips.empty() || goals.frames() < 2) return {};
  std::vector<std::vector<Vec3>> positions(goals.frames());
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    for (const std::size_t tip : tips) positions[f].push_back(goals.tip_position(f, tip));
  }
  return central_differences(positions, step_of(goals));
}

double spectral_arc_length(const SpeedProfile& profile) {
  constexpr double kCutoff_hz = 10, kThreshold = 0.05;
  if (!moves(profile)) return kUnknown;
  double padded = 16;  // number of instants
  for (std::size_t n = 1; n < profile.speed.size(); n *= 2) padded *= 2;
  const double bin_hz = 1 / (padded * profile.step_s);
  const std::ptrdiff_t bins =
      std::lround(std::floor(std::min(kCutoff_hz / bin_hz * (1 + 1e-12), padded - 1)));
  // A speed is nonnegative, so that its spectrum is greatest at frequency 0.
  const double max_magnitude = spectrum_at(profile.speed, 0);
  std::vector<double> magnitude;
  for (std::ptrdiff_t k = 0; k <= bins; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / padded;
    magnitude.push_back(spectrum_at(profile.speed, angle) / max_magnitude);
  }
  std::ptrdiff_t last = bins;
  while (magnitude[last] < kThreshold) --last;
  if (last < 1) return kUnknown;
  double length = 0;
  for (std::ptrdiff_t k = 0; k < last; ++k) {
    length += std::hypot(1 / static_cast<double>(last), magnitude[k + 1] - magnitude[k]);
  }
  return -length;
}

double log_dimensionless_jerk(const SpeedProfile& profile) {
  if (!moves(profile)) return kUnknown;
  const std::vector<double>& v = profile.speed;
  const double h = profile.step_s;
  double squared_jerk = 0;
  for (int i = 1; i + 1 < std::ssize(v); ++i) {
    const double jerk = (v[i + 1] - 2 * v[i] + v[i - 1]) / (h * h);
    squared_jerk += jerk * jerk * h;
  }
  const double duration_s = h * static_cast<double>(v.size() - 1);
  const double peak = std::ranges::max(v);
  return -std::log(std::pow(duration_s, 3) / (peak * peak) * squared_jerk);
}

}  // namespace morphe::certify
