#include "pipeline/study/retime_reference.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/fit_path.hpp"

namespace morphe::study {
namespace {

/// The range of path accelerations that all joints allow; empty if lower > upper.
struct AllowedRange {
  double lower = -kInfinity, upper = kInfinity;
};

/// Returns the range at a squared path velocity x; rows 1 and 2 of q are its derivatives.
AllowedRange allowed_accelerations(const retime::ConstrainedPath& path, const JointRows& q,
                                   double x) {
  AllowedRange range;
  for (Eigen::Index k = 0; k < q.cols(); ++k) {
    const double slope = q(1, k), curvature = q(2, k) * x, limit = path.acceleration[k];
    if (std::abs(slope) < 1e-9) {
      if (std::abs(curvature) > limit) return {1, -1};
      continue;
    }
    const double at_lower = (-limit - curvature) / slope, at_upper = (limit - curvature) / slope;
    range.lower = std::max(range.lower, std::min(at_lower, at_upper));
    range.upper = std::min(range.upper, std::max(at_lower, at_upper));
  }
  return range;
}

}  // namespace

retime::ConstrainedPath paced_path_without_jerk(const RobotModel& robot, const JointPath& path,
                                                const Movement& movement) {
  constexpr double kKnotStep_s = 0.01;
  retime::ConstrainedPath constrained;
  constrained.robot = &robot;
  constrained.movement = &movement;
  constrained.parameterized = retime::parameterize_path(robot, path, kKnotStep_s, false);
  const retime::ParameterizedPath& points = constrained.parameterized;
  const std::vector<double> allowance(points.parameter.size(), 1);
  constrained.spline =
      retime::fit_path(robot, points.parameter, points.position, allowance, {}, kKnotStep_s).spline;
  constrained.velocity = robot.velocity;
  constrained.acceleration = robot.acceleration;
  constrained.jerk = JointVector::Constant(robot.jerk.size(), kInfinity);
  return constrained;
}

double reference_least_time_s(const retime::ConstrainedPath& path, int steps) {
  const double h = path.spline.duration_s / steps;
  std::vector<JointRows> q(steps + 1);
  for (int i = 0; i <= steps; ++i) math::evaluate(path.spline, h * i, q[i]);
  std::vector<double> max_x(q.size(), 0);  // x is the squared path velocity
  for (int i = steps - 1; i >= 0; --i) {
    double ceiling = retime::kMaxPathVelocity * retime::kMaxPathVelocity;
    for (Eigen::Index k = 0; k < path.velocity.size(); ++k)
      ceiling = std::min(ceiling, std::pow(path.velocity[k] / std::abs(q[i](1, k)), 2));
    const auto can_continue = [&](double x) {
      const AllowedRange range = allowed_accelerations(path, q[i], x);
      return std::max(range.lower, -x / (2 * h)) <=
             std::min(range.upper, (max_x[i + 1] - x) / (2 * h));
    };
    double low = 0, high = ceiling;
    for (int k = 0; k < 60 && !can_continue(high); ++k) {
      const double middle = 0.5 * (low + high);
      (can_continue(middle) ? low : high) = middle;
    }
    max_x[i] = can_continue(high) ? high : low;
  }
  double x = 0, time_s = 0;
  for (int i = 0; i < steps; ++i) {
    const double next =
        std::clamp(x + 2 * h * allowed_accelerations(path, q[i], x).upper, 0.0, max_x[i + 1]);
    time_s += 2 * h / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  return time_s;
}

}  // namespace morphe::study
