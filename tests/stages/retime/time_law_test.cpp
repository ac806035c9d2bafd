// Closed forms; tests/stages/study holds the law against another method on a finer grid.
#include "stages/retime/time_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace morphe::retime {
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

TEST(TimeLaw, RestIsTheSameMotionAndThenNone) {
  const Movement movement;
  Course course = line_course(JointVector::Constant(1, 0.3), 1, 3, 30, movement);
  course.clocked.clock = course.clocked.demonstration_time = {0, 1};
  course.clocked.origin = {Origin::mapped, Origin::mapped};
  PacedLaw paced = pace_fastest(course, 500);
  const Trajectory early = sample_law(course, paced, 500).trajectory;
  paced.rest = 40;
  const Trajectory t = sample_law(course, paced, 500).trajectory;
  const Eigen::Index rows = early.position.rows();
  ASSERT_EQ(t.position.rows(), rows + 40);
  EXPECT_EQ(t.position.topRows(rows), early.position);
  EXPECT_EQ(t.velocity.topRows(rows), early.velocity);
  EXPECT_EQ(t.acceleration.topRows(rows), early.acceleration);
  EXPECT_TRUE((t.position.bottomRows(41).array() == t.position(rows - 1, 0)).all());
  EXPECT_TRUE(t.velocity.bottomRows(41).isZero(0));
  EXPECT_TRUE(t.acceleration.bottomRows(41).isZero(0));
  EXPECT_NEAR(t.time.back(), early.time.back() + 0.08, 1e-12);
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
}  // namespace morphe::retime
