// Closed forms; tests/pipeline/study holds the law against another method on a finer grid.
#include "stages/retime/time_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace morphe::retime {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A straight line from 0 to `way` over one second of the clock.
ConstrainedPath line_path(const JointVector& way, double velocity, double acceleration, double jerk,
                          const Movement& movement) {
  static const RobotModel robot;  // without braking curves
  ConstrainedPath paced_path;
  const Eigen::Index n = way.size(), intervals = 100;
  paced_path.robot = &robot;
  paced_path.movement = &movement;
  paced_path.spline.duration_s = 1;
  paced_path.spline.intervals = intervals;
  paced_path.spline.origin = Eigen::RowVectorXd::Zero(n);
  paced_path.spline.coefficient.resize(intervals + 5, n);
  for (Eigen::Index i = 0; i < intervals + 5; ++i) {
    paced_path.spline.coefficient.row(i) =
        way.transpose() * (static_cast<double>(i) - 2) / intervals;
  }
  paced_path.velocity = JointVector::Constant(n, velocity);
  paced_path.acceleration = JointVector::Constant(n, acceleration);
  paced_path.jerk = JointVector::Constant(n, jerk);
  return paced_path;
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
    const ConstrainedPath one = line_path(JointVector::Constant(1, way), 1, 3, kInfinity, movement);
    EXPECT_NEAR(fastest_law(one).duration_s / least_time(way, 1, 3, kInfinity), 1, 0.002) << way;
    JointVector ways(3);
    ways << 0.4 * way, -way, 0.1 * way;
    const ConstrainedPath line = line_path(ways, 1, 3, kInfinity, movement);
    EXPECT_NEAR(fastest_law(line).duration_s / least_time(way, 1, 3, kInfinity), 1, 0.002) << way;
  }
}

TEST(TimeLaw, SevenSegments) {
  const Movement movement;
  for (const double way : {0.01, 0.1, 0.5, 1.0, 3.0}) {
    for (const double jerk : {10.0, 30.0, 300.0}) {
      const ConstrainedPath paced_path =
          line_path(JointVector::Constant(1, way), 1, 3, jerk, movement);
      const double ratio = fastest_law(paced_path).duration_s / least_time(way, 1, 3, jerk);
      EXPECT_GE(ratio, 0.998) << way << " " << jerk;
      EXPECT_LE(ratio, 1.03) << way << " " << jerk;
    }
  }
}

TEST(TimeLaw, RestIsTheSameMotionAndThenNone) {
  const Movement movement;
  ConstrainedPath paced_path = line_path(JointVector::Constant(1, 0.3), 1, 3, 30, movement);
  paced_path.parameterized.parameter = paced_path.parameterized.demonstration_time = {0, 1};
  paced_path.parameterized.origin = {SampleOrigin::mapped, SampleOrigin::mapped};
  QuantizedLaw paced = fastest_mode_law(paced_path, 500);
  const Trajectory early = sample_law(paced_path, paced, 500).trajectory;
  paced.rest = 40;
  const Trajectory t = sample_law(paced_path, paced, 500).trajectory;
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
