#include "pipeline/study/retime_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stages/retime/fit_path.hpp"

namespace morphe::study {
namespace {

/// The path accelerations that all joints allow; empty if least > most.
struct AllowedRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

AllowedRange allowed_accelerations(const retime::ConstrainedPath& course, const JointRows& q,
                                   double x) {
  AllowedRange range;
  for (Eigen::Index k = 0; k < q.cols(); ++k) {
    const double first = q(1, k), rest = q(2, k) * x, limit = course.acceleration[k];
    if (std::abs(first) < 1e-9) {
      if (std::abs(rest) > limit) return {1, -1};
      continue;
    }
    const double one = (-limit - rest) / first, other = (limit - rest) / first;
    range.least = std::max(range.least, std::min(one, other));
    range.most = std::min(range.most, std::max(one, other));
  }
  return range;
}

}  // namespace

retime::ConstrainedPath paced_path_without_jerk(const RobotModel& robot, const JointPath& path,
                                                const Movement& movement) {
  constexpr double kKnotStep_s = 0.01;
  retime::ConstrainedPath course;
  course.robot = &robot;
  course.movement = &movement;
  course.parameterized = retime::parameterize_path(robot, path, kKnotStep_s, false);
  const std::vector<double> allowance(course.parameterized.parameter.size(), 1);
  course.spline = retime::fit_path(robot, course.parameterized.parameter,
                                   course.parameterized.position, allowance, {}, kKnotStep_s)
                      .spline;
  course.velocity = robot.velocity;
  course.acceleration = robot.acceleration;
  course.jerk = JointVector::Constant(robot.jerk.size(), std::numeric_limits<double>::infinity());
  return course;
}

double reference_least_time_s(const retime::ConstrainedPath& course, int steps) {
  const double h = course.spline.duration_s / steps;
  std::vector<JointRows> q(steps + 1);
  for (std::size_t i = 0; i < q.size(); ++i) {
    math::evaluate(course.spline, h * static_cast<double>(i), q[i]);
  }
  std::vector<double> most(q.size(), 0);
  for (std::size_t i = q.size() - 1; i-- > 0;) {
    double ceiling = retime::kMaxPathVelocity * retime::kMaxPathVelocity;
    for (Eigen::Index k = 0; k < course.velocity.size(); ++k) {
      ceiling = std::min(ceiling, std::pow(course.velocity[k] / std::abs(q[i](1, k)), 2));
    }
    const auto reaches = [&](double x) {
      const AllowedRange range = allowed_accelerations(course, q[i], x);
      return std::max(range.least, -x / (2 * h)) <=
             std::min(range.most, (most[i + 1] - x) / (2 * h));
    };
    double low = 0, high = ceiling;
    for (int k = 0; k < 60 && !reaches(high); ++k) {
      const double middle = 0.5 * (low + high);
      (reaches(middle) ? low : high) = middle;
    }
    most[i] = reaches(high) ? high : low;
  }
  double x = 0, time_s = 0;
  for (std::size_t i = 0; i + 1 < q.size(); ++i) {
    const double next =
        std::clamp(x + 2 * h * allowed_accelerations(course, q[i], x).most, 0.0, most[i + 1]);
    time_s += 2 * h / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  return time_s;
}

}  // namespace morphe::study
