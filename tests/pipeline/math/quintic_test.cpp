#include "pipeline/math/quintic.hpp"

#include <gtest/gtest.h>

#include <random>

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
  EXPECT_NEAR(beyond(parabola, -1, 0.75), 0.25, 1e-14);
  EXPECT_EQ(beyond(parabola, 0, 1.0000001), 0);
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const QuinticPiece piece = random_piece(random, 0.3);
    const Range over = extremes(piece).position;
    const double out = std::max({0.0, -0.5 - over.least, over.greatest - 0.8});
    EXPECT_EQ(beyond(piece, -0.5, 0.8), out);
  }
}

TEST(Quintic, JudgesATrajectoryBetweenItsSamples) {
  RobotTable robot;
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

}  // namespace
}  // namespace morphe::math
