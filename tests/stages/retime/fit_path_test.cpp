#include "stages/retime/fit_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::retime {
namespace {

RobotModel bare_robot(Eigen::Index joints, double lower, double upper) {
  RobotModel robot;
  robot.joint_names.assign(static_cast<std::size_t>(joints), "joint");
  robot.lower = JointVector::Constant(joints, lower);
  robot.upper = JointVector::Constant(joints, upper);
  return robot;
}

/// Two links of 0.5 m in a plane with a tip at their end, and a joint that carries nothing.
RobotModel planar_arm() {
  RobotModel robot = bare_robot(3, -3, 3);
  for (int joint = 0; joint < 3; ++joint) {
    RobotModel::Frame frame;
    frame.parent = joint == 0 ? -1 : 0;
    frame.joint = joint;
    frame.transform.translation() = Vec3(joint == 0 ? 0 : 0.5, 0, 0);
    robot.frames.push_back(frame);
  }
  RobotModel::Tip tip;
  tip.frame = 1;
  tip.transform.translation() = Vec3(0.5, 0, 0);
  robot.tips.push_back(tip);
  return robot;
}

double tip_distance(const RobotModel& robot, const JointVector& a, const JointVector& b) {
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, a, frames);
  const Vec3 first = robot::tip_pose(robot, frames, 0).translation();
  robot::forward_kinematics(robot, b, frames);
  return (robot::tip_pose(robot, frames, 0).translation() - first).norm();
}

TEST(FitPath, FollowsASine) {
  std::vector<double> clock;
  JointRows y(201, 1);
  for (int i = 0; i <= 200; ++i) {
    clock.push_back(0.005 * i);
    y(i, 0) = std::sin(4 * clock.back());
  }
  const std::vector<double> allowance(clock.size(), 1);
  const PathFit fit = fit_path(bare_robot(1, -2, 2), clock, y, allowance, {0.003, 0, 0}, 0.01);
  EXPECT_LT(fit.joint_deviation, 1e-6);
  JointRows q;
  for (double u = 0.1; u < 0.9; u += 0.0137) {
    math::evaluate(fit.spline, u, q);
    EXPECT_NEAR(q(0, 0), std::sin(4 * u), 1e-6);
    EXPECT_NEAR(q(1, 0), 4 * std::cos(4 * u), 1e-4);
    EXPECT_NEAR(q(2, 0), -16 * std::sin(4 * u), 1e-2);
    EXPECT_NEAR(q(3, 0), -64 * std::cos(4 * u), 1.0);
  }
}

TEST(FitPath, StaysWithinLimits) {
  std::vector<double> clock;
  JointRows y(101, 1);
  for (int i = 0; i <= 100; ++i) {
    clock.push_back(0.01 * i);
    y(i, 0) = std::min(0.5, 0.8 * clock.back());
  }
  const std::vector<double> allowance(clock.size(), 1);
  const PathFit fit = fit_path(bare_robot(1, 0, 0.5), clock, y, allowance, {0.03, 0, 1e-3}, 0.01);
  EXPECT_LE(fit.joint_deviation, 1e-3);
  JointRows q;
  for (double u = 0; u <= 1; u += 0.0013) {
    math::evaluate(fit.spline, u, q);
    EXPECT_LE(q(0, 0), 0.5);
    EXPECT_GE(q(0, 0), 0.0);
  }
}

/// The coefficients of such a curve lie beyond the limit; the curve does not, and must not swing.
TEST(FitPath, LeavesAndMeetsALimitAtOnceWithoutRinging) {
  const auto way = [](double u) { return 0.3 * std::sin(2.5 * u); };  // 0 at 0, steep from there on
  std::vector<double> clock;
  JointRows y(101, 2);
  for (int i = 0; i <= 100; ++i) {
    clock.push_back(0.01 * i);
    y(i, 0) = way(clock.back());
    y(i, 1) = 0.5 - way(1 - clock.back());  // meets its upper limit at the end
  }
  const std::vector<double> allowance(clock.size(), 1);
  RobotModel robot = bare_robot(2, 0, 0.5);
  const PathFit fit = fit_path(robot, clock, y, allowance, {0.02, 0, 1.5e-3}, 0.01);
  EXPECT_LE(fit.joint_deviation, 1.5e-3);
  JointRows q;
  for (double u = 0; u <= 1; u += 0.0007) {
    math::evaluate(fit.spline, u, q);
    EXPECT_GE(q.row(0).minCoeff(), 0);
    EXPECT_LE(q.row(0).maxCoeff(), 0.5);
    EXPECT_NEAR(q(1, 0), 0.75 * std::cos(2.5 * u), 0.02) << u;
    EXPECT_NEAR(q(1, 1), 0.75 * std::cos(2.5 * (1 - u)), 0.02) << u;
    EXPECT_LT(std::abs(q(3, 0)), 3 * 0.3 * 2.5 * 2.5 * 2.5) << u;
  }
}

TEST(FitPath, MeetsItsEndsHoweverMuchIsSmoothed) {
  // A corner at the first sample and steps at random: the roughest ends there are.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(-0.02, 0.02);
  std::vector<double> clock;
  JointRows y(150, 2);
  for (int i = 0; i < 150; ++i) {
    clock.push_back(0.01 * i);
    for (int j = 0; j < 2; ++j) y(i, j) = (i > 0 ? y(i - 1, j) : 0.3) + step(random);
  }
  FitTolerance loose;
  loose.duration_s = 0.08;
  loose.joint_rad = 0.05;
  const PathFit fitted =
      fit_path(bare_robot(2, -3, 3), clock, y, std::vector<double>(150, 4), loose, 0.01);
  JointRows at;
  math::evaluate(fitted.spline, 0, at);
  EXPECT_LT((at.row(0) - y.row(0)).norm(), 1e-6);
  math::evaluate(fitted.spline, fitted.spline.duration_s, at);
  EXPECT_LT((at.row(0) - y.row(149)).norm(), 1e-6);
}

TEST(FitPath, MeetsItsEndsWhereTheCurveReachesALimitSoonAfter) {
  std::vector<double> clock;
  JointRows y(150, 1);
  for (int i = 0; i < 150; ++i) {
    clock.push_back(0.01 * i);
    y(i, 0) = std::max(0.0, 0.06 - 0.006 * i) + (i == 0 ? -0.002 : 0.0);  // a corner at the end
  }
  FitTolerance loose;
  loose.duration_s = 0.08;
  loose.joint_rad = 0.05;
  const PathFit fitted =
      fit_path(bare_robot(1, 0, 3), clock, y, std::vector<double>(150, 4), loose, 0.01);
  JointRows at;
  math::evaluate(fitted.spline, 0, at);
  EXPECT_NEAR(at(0, 0), y(0, 0), 1e-6);
  for (int i = 0; i <= 1490; ++i) {
    math::evaluate(fitted.spline, 0.001 * i, at);
    EXPECT_GE(at(0, 0), 0) << i;
  }
}

TEST(FitPath, NoiseIsRemovedWithinTheTipsTolerance) {
  const RobotModel robot = planar_arm();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  std::vector<double> clock;
  JointRows y(151, 3);
  for (int i = 0; i <= 150; ++i) {
    clock.push_back(0.01 * i);
    for (int joint = 0; joint < 3; ++joint) {
      y(i, joint) = std::sin(2 * clock.back() + joint) + noise(random);
    }
  }
  const std::vector<double> allowance(clock.size(), 1);
  const FitTolerance tolerance{0.05, 2e-4, 3e-4};
  const PathFit fit = fit_path(robot, clock, y, allowance, tolerance, 0.01);
  double tip = 0, bare = 0, rough = 0, given = 0;
  JointRows q;
  for (int i = 0; i <= 150; ++i) {
    math::evaluate(fit.spline, clock[static_cast<std::size_t>(i)], q);
    const JointVector at = q.row(0).transpose(), sample = y.row(i).transpose();
    tip = std::max(tip, tip_distance(robot, at, sample));
    bare = std::max(bare, std::abs(at[2] - sample[2]));
    if (i < 5 || i > 145) continue;
    for (int joint = 0; joint < 3; ++joint) {
      const double truth = -4 * std::sin(2 * clock[static_cast<std::size_t>(i)] + joint);
      const double differences =
          (y(i - 1, joint) - 2 * y(i, joint) + y(i + 1, joint)) / (0.01 * 0.01);
      rough = std::max(rough, std::abs(q(2, joint) - truth));
      given = std::max(given, std::abs(differences - truth));
    }
  }
  EXPECT_LE(tip, 2e-4);
  EXPECT_LE(bare, 3e-4);
  EXPECT_NEAR(fit.tip_deviation, tip, 0.02 * tip);
  EXPECT_LT(rough, 0.2 * given);
}

}  // namespace
}  // namespace morphe::retime
