// Closed forms and a reference of its own: how far the laws are from the least time there is.
#include "stages/retime/time_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace morphe {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A straight line from 0 to `way` over one second of the clock.
Course line_course(const JointVector& way, double velocity, double acceleration, double jerk,
                   const Movement& movement) {
  Course course;
  const Eigen::Index n = way.size(), intervals = 100;
  course.movement = &movement;
  course.spline.length = 1;
  course.spline.intervals = intervals;
  course.spline.origin = Eigen::RowVectorXd::Zero(n);
  course.spline.coefficient.resize(intervals + 5, n);
  for (Eigen::Index i = 0; i < intervals + 5; ++i) {
    course.spline.coefficient.row(i) = way.transpose() * (static_cast<double>(i) - 2) / intervals;
  }
  course.velocity = JointVector::Constant(n, velocity);
  course.acceleration = JointVector::Constant(n, acceleration);
  course.jerk = JointVector::Constant(n, jerk);
  return course;
}

/// Rest to rest over a distance d: trapezoid or triangle of velocity; with a jerk limit the seven
/// segments.
double least_time(double d, double v, double a, double j) {
  if (!std::isfinite(j)) return d >= v * v / a ? d / v + v / a : 2 * std::sqrt(d / a);
  // Peak velocity u: ramps of u / a + a / j, or 2 sqrt(u / j) if a is not reached.
  const auto ramp = [&](double u) { return u >= a * a / j ? u / a + a / j : 2 * std::sqrt(u / j); };
  if (v * ramp(v) <= d) return d / v + ramp(v);
  double low = 0, high = v;
  for (int k = 0; k < 200; ++k) {
    const double u = 0.5 * (low + high);
    (u * ramp(u) < d ? low : high) = u;
  }
  return 2 * ramp(low);
}

TEST(TimeLaw, TrapezoidTriangleAndStraightLine) {
  const Movement movement;
  for (const double way : {0.05, 0.3, 1.0, 3.0}) {
    const Course one = line_course(JointVector::Constant(1, way), 1, 3, kInfinity, movement);
    EXPECT_NEAR(fastest_law(one).duration_s / least_time(way, 1, 3, kInfinity), 1, 0.002) << way;
    JointVector ways(3);
    ways << 0.4 * way, -way, 0.1 * way;
    const Course line = line_course(ways, 1, 3, kInfinity, movement);
    EXPECT_NEAR(fastest_law(line).duration_s / least_time(way, 1, 3, kInfinity), 1, 0.002) << way;
  }
}

TEST(TimeLaw, SevenSegments) {
  const Movement movement;
  for (const double way : {0.01, 0.1, 0.5, 1.0, 3.0}) {
    for (const double jerk : {10.0, 30.0, 300.0}) {
      const Course course = line_course(JointVector::Constant(1, way), 1, 3, jerk, movement);
      const double ratio = fastest_law(course).duration_s / least_time(way, 1, 3, jerk);
      EXPECT_GE(ratio, 0.998) << way << " " << jerk;
      EXPECT_LE(ratio, 1.03) << way << " " << jerk;
    }
  }
}

/// Random sines in some joints, on a spline whose coefficients they are.
Course wave_course(unsigned seed, const Movement& movement) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto joints = static_cast<Eigen::Index>(1 + seed % 9);
  Course course = line_course(JointVector::Zero(joints), 1, 1, kInfinity, movement);
  for (Eigen::Index k = 0; k < joints; ++k) {
    course.velocity[k] = 0.5 + 2 * unit(random);
    course.acceleration[k] = 2 + 10 * unit(random);
    const double amplitude = 0.2 + unit(random), begin = 6.3 * unit(random);
    const double rate = 2 + 8 * unit(random);
    for (Eigen::Index i = 0; i < course.spline.coefficient.rows(); ++i) {
      course.spline.coefficient(i, k) =
          amplitude * std::sin(begin + rate * static_cast<double>(i) / 100);
    }
  }
  return course;
}

/// The least time on a grid 40 times finer, by bisection: the range of a at x, from all joints,
/// either leaves something or not. Constraints at the near end of each step alone.
double reference_time(const Course& course) {
  constexpr int kSteps = 20000;
  const double h = course.spline.length / kSteps;
  std::vector<JointRows> q(kSteps + 1);
  for (int i = 0; i <= kSteps; ++i) {
    evaluate(course.spline, h * i, q[static_cast<std::size_t>(i)]);
  }
  const auto range = [&](int i, double x) {
    std::pair<double, double> a{-kInfinity, kInfinity};
    const JointRows& at = q[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < at.cols(); ++k) {
      const double first = at(1, k), rest = at(2, k) * x, limit = course.acceleration[k];
      if (std::abs(first) < 1e-9) {
        if (std::abs(rest) > limit) return std::pair{1.0, -1.0};
        continue;
      }
      const double one = (-limit - rest) / first, other = (limit - rest) / first;
      a.first = std::max(a.first, std::min(one, other));
      a.second = std::min(a.second, std::max(one, other));
    }
    return a;
  };
  std::vector<double> most(kSteps + 1, 0);
  for (int i = kSteps - 1; i >= 0; --i) {
    const auto n = static_cast<std::size_t>(i);
    double ceiling = 1e6;
    for (Eigen::Index k = 0; k < course.velocity.size(); ++k) {
      ceiling = std::min(ceiling, std::pow(course.velocity[k] / std::abs(q[n](1, k)), 2));
    }
    const auto reaches = [&](double x) {
      const auto [low, high] = range(i, x);
      return std::max(low, -x / (2 * h)) <= std::min(high, (most[n + 1] - x) / (2 * h));
    };
    double low = 0, high = ceiling;
    for (int k = 0; k < 60 && !reaches(high); ++k) {
      const double middle = 0.5 * (low + high);
      (reaches(middle) ? low : high) = middle;
    }
    most[n] = reaches(high) ? high : low;
  }
  double x = 0, time_s = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = range(i, x).second;
    const double next = std::clamp(x + 2 * h * a, 0.0, most[static_cast<std::size_t>(i + 1)]);
    time_s += 2 * h / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  return time_s;
}

TEST(TimeLaw, WithinHalfAPercentOfAFinerGrid) {
  const Movement movement;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Course course = wave_course(seed, movement);
    const double ratio = fastest_law(course).duration_s / reference_time(course);
    EXPECT_GE(ratio, 0.995) << seed;
    EXPECT_LE(ratio, 1.005) << seed;
  }
}

TEST(TimeLaw, TheLawIsWhereTheGridSays) {
  const GridLaw law = grid_law(0.5, Eigen::Vector3d(0, 4, 0));
  // Acceleration 4 for 0.5, then braking: t = sqrt(2 * 0.5 / 4) each.
  EXPECT_NEAR(law.time[2], 1, 1e-12);
  EXPECT_NEAR(clock_at(law, 0.25), 0.125, 1e-12);
  EXPECT_NEAR(clock_at(law, 0.75), 0.875, 1e-12);
  EXPECT_EQ(clock_at(law, -1), 0);
  EXPECT_EQ(clock_at(law, 2), 1);
}

}  // namespace
}  // namespace morphe
