#include "core/math/quintic.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/math/limit_report.hpp"

namespace morphe::math {
namespace {

QuinticPiece random_piece(std::mt19937& random, double duration) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto state = [&] { return JointState{any(random), 5 * any(random), 40 * any(random)}; };
  const JointState begin = state(), end = state();
  return quintic_piece(begin, end, duration);
}

TEST(Quintic, MeetsBothEnds) {
  const JointState begin{0.3, -1.2, 4.5}, end{0.7, 2.1, -3.3};
  const QuinticPiece piece = quintic_piece(begin, end, 0.37);
  EXPECT_NEAR(value_at(piece, 0, 0), begin.position, 1e-13);
  EXPECT_NEAR(value_at(piece, 0, 1), begin.velocity, 1e-12);
  EXPECT_NEAR(value_at(piece, 0, 2), begin.acceleration, 1e-11);
  EXPECT_NEAR(value_at(piece, 0.37, 0), end.position, 1e-13);
  EXPECT_NEAR(value_at(piece, 0.37, 1), end.velocity, 1e-12);
  EXPECT_NEAR(value_at(piece, 0.37, 2), end.acceleration, 1e-10);
}

TEST(Quintic, RestToRestIsTheMinimumJerkMotion) {
  // 10 z^3 - 15 z^4 + 6 z^5: peak velocity 15/8, acceleration 10/sqrt(3), jerk 60 (at the ends).
  const QuinticPiece piece = quintic_piece({0, 0, 0}, {1, 0, 0}, 1);
  const QuinticExtremes over = extremes(piece);
  EXPECT_NEAR(over.velocity.greatest, 15.0 / 8, 1e-13);
  EXPECT_NEAR(over.velocity.least, 0, 1e-13);
  EXPECT_NEAR(over.acceleration.greatest, 10 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(over.acceleration.least, -10 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(over.jerk.greatest, 60, 1e-11);
  EXPECT_NEAR(over.jerk.least, -30, 1e-11);
  EXPECT_DOUBLE_EQ(over.position.greatest, 1);
}

TEST(Quintic, ExtremesEqualDenseSampling) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const double duration = trial % 2 ? 0.002 : 0.8;
    const QuinticPiece piece = random_piece(random, duration);
    const QuinticExtremes over = extremes(piece);
    const Range found[4] = {over.position, over.velocity, over.acceleration, over.jerk};
    for (int order = 0; order < 4; ++order) {
      double least = value_at(piece, 0, order), greatest = least;
      for (int i = 1; i <= 2000; ++i) {
        const double value = value_at(piece, duration * i / 2000, order);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
      const double scale = std::max({1e-3, std::abs(least), std::abs(greatest)});
      EXPECT_LE(found[order].least, least + 1e-12 * scale);
      EXPECT_GE(found[order].greatest, greatest - 1e-12 * scale);
      EXPECT_NEAR(found[order].least, least, 1e-4 * scale);
      EXPECT_NEAR(found[order].greatest, greatest, 1e-4 * scale);
    }
  }
}

TEST(Quintic, BeyondARangeIsWhatTheExtremesSay) {
  // 1 - (2 z - 1)^2: a quintic with a parabola's states at both ends is that parabola.
  const QuinticPiece parabola = quintic_piece({0, 4, -8}, {0, -4, -8}, 1);
  EXPECT_NEAR(limit_excess(parabola, -1, 0.75), 0.25, 1e-14);
  EXPECT_EQ(limit_excess(parabola, 0, 1.0000001), 0);
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const QuinticPiece piece = random_piece(random, 0.3);
    const Range over = extremes(piece).position;
    const double out = std::max({0.0, -0.5 - over.least, over.greatest - 0.8});
    EXPECT_EQ(limit_excess(piece, -0.5, 0.8), out);
  }
}

/// Two samples of some joints in random states.
Trajectory random_step(std::mt19937& random, Eigen::Index joints, double duration_s) {
  std::uniform_real_distribution<double> any(-1, 1);
  Trajectory trajectory;
  trajectory.time = {0, duration_s};
  trajectory.position = JointRows::NullaryExpr(2, joints, [&] { return any(random); });
  trajectory.velocity = 3 * JointRows::NullaryExpr(2, joints, [&] { return any(random); });
  trajectory.acceleration = 20 * JointRows::NullaryExpr(2, joints, [&] { return any(random); });
  return trajectory;
}

TEST(Quintic, AnEnclosureHoldsItsCurves) {
  std::mt19937 random(5);
  Enclosure within;
  double closest = 1e9;  // of an enclosure to the velocity it encloses
  for (int trial = 0; trial < 200; ++trial) {
    const Trajectory step = random_step(random, 7, trial % 2 == 0 ? 0.002 : 0.8);
    enclose(step, 0, within);
    for (Eigen::Index joint = 0; joint < 7; ++joint) {
      const QuinticExtremes over = extremes(quintic_piece(step, 0, joint));
      const auto magnitude = [](const Range& range) {
        return std::max(-range.least, range.greatest);
      };
      EXPECT_LE(within.lowest[joint], over.position.least + 1e-12);
      EXPECT_GE(within.highest[joint], over.position.greatest - 1e-12);
      EXPECT_GE(within.velocity[joint], magnitude(over.velocity) * (1 - 1e-12));
      EXPECT_GE(within.acceleration[joint], magnitude(over.acceleration) * (1 - 1e-10));
      EXPECT_GE(within.jerk[joint], magnitude(over.jerk) * (1 - 1e-8));
      closest = std::min(closest, within.velocity[joint] / magnitude(over.velocity));
    }
  }
  EXPECT_LT(closest, 1.01);
}

TEST(Quintic, ReportsTheWorstOfManySteps) {
  std::mt19937 random(6);
  constexpr Eigen::Index kSamples = 40, kJoints = 5;
  std::uniform_real_distribution<double> any(-1, 1);
  Trajectory trajectory;
  for (Eigen::Index i = 0; i < kSamples; ++i)
    trajectory.time.push_back(0.1 * static_cast<double>(i));
  for (JointRows* rows : {&trajectory.position, &trajectory.velocity, &trajectory.acceleration})
    *rows = JointRows::NullaryExpr(kSamples, kJoints, [&] { return any(random); });
  RobotModel robot;
  robot.joint_names.assign(kJoints, "a");
  robot.lower = JointVector::Constant(kJoints, -3);
  robot.upper = JointVector::Constant(kJoints, 3);
  robot.velocity = robot.acceleration = robot.jerk = JointVector::LinSpaced(kJoints, 1, 2);
  double velocity = 0, acceleration = 0, jerk = 0, margin = 1e9;
  for (std::size_t i = 0; i + 1 < trajectory.samples(); ++i) {
    for (Eigen::Index j = 0; j < kJoints; ++j) {
      const QuinticExtremes over = extremes(quintic_piece(trajectory, i, j));
      const auto use = [&](const Range& range) {
        return std::max(-range.least, range.greatest) / robot.velocity[j];
      };
      velocity = std::max(velocity, use(over.velocity));
      acceleration = std::max(acceleration, use(over.acceleration));
      jerk = std::max(jerk, use(over.jerk));
      margin = std::min({margin, over.position.least + 3, 3 - over.position.greatest});
    }
  }
  const LimitReport report = limit_report(robot, trajectory);
  EXPECT_EQ(report.velocity.ratio, velocity);
  EXPECT_EQ(report.acceleration.ratio, acceleration);
  EXPECT_EQ(report.jerk.ratio, jerk);
  EXPECT_EQ(report.position_margin, margin);
}

TEST(Quintic, JudgesATrajectoryBetweenItsSamples) {
  RobotModel robot;
  robot.joint_names = {"a"};
  robot.lower = JointVector::Constant(1, -0.5);
  robot.upper = JointVector::Constant(1, 1.25);
  robot.velocity = JointVector::Constant(1, 15.0 / 8);
  robot.acceleration = JointVector::Constant(1, 10);
  robot.jerk = JointVector::Constant(1, 30);
  Trajectory trajectory;
  trajectory.time = {0, 1};
  trajectory.position = JointRows::Zero(2, 1);
  trajectory.position(1, 0) = 1;
  trajectory.velocity = trajectory.acceleration = JointRows::Zero(2, 1);
  const LimitReport report = limit_report(robot, trajectory);
  EXPECT_NEAR(report.velocity.ratio, 1, 1e-13);
  EXPECT_NEAR(report.acceleration.ratio, 1 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(report.jerk.ratio, 2, 1e-12);
  EXPECT_EQ(report.jerk.sample, 0);
  EXPECT_DOUBLE_EQ(report.position_margin, 0.25);
}

/// The acceleration of a cubic Hermite piece is linear, so that it is greatest at an end:
/// (6 d / h - 4 v0 - 2 v1) / h and (-6 d / h + 2 v0 + 4 v1) / h for the distance d in h seconds.
TEST(Quintic, ACubicPieceAcceleratesMostAtItsEnds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  RobotModel robot;
  robot.joint_names = {"a"};
  robot.lower = JointVector::Constant(1, -3);
  robot.upper = JointVector::Constant(1, 3);
  robot.velocity = JointVector::Constant(1, 2);
  robot.acceleration = robot.jerk = JointVector::Constant(1, 5);
  for (int k = 0; k < 100; ++k) {
    const double h = 0.3, d = any(random), v0 = any(random), v1 = any(random);
    Trajectory t;
    t.time = {1, 1 + h};
    t.position = t.velocity = JointRows::Zero(2, 1);
    t.acceleration = JointRows::Constant(2, 1, kUnknown);  // is not used
    t.position(1, 0) = d;
    t.velocity.col(0) << v0, v1;
    const double a0 = (6 * d / h - 4 * v0 - 2 * v1) / h, a1 = (-6 * d / h + 2 * v0 + 4 * v1) / h;
    double speed = std::max(std::abs(v0), std::abs(v1));
    const double turn_s = -a0 * h / (a1 - a0);  // where the acceleration is zero
    if (turn_s > 0 && turn_s < h) speed = std::max(speed, std::abs(v0 + a0 * turn_s / 2));
    const CubicLimitReport use = cubic_limit_report(robot, t);
    EXPECT_NEAR(use.acceleration.ratio, std::max(std::abs(a0), std::abs(a1)) / 5, 1e-10);
    EXPECT_NEAR(use.velocity.ratio, speed / 2, 1e-10);
    EXPECT_NEAR(value_at(cubic_piece(t, 0, 0), h, 0), d, 1e-14);
    EXPECT_NEAR(value_at(cubic_piece(t, 0, 0), h, 1), v1, 1e-13);
  }
}

}  // namespace
}  // namespace morphe::math
