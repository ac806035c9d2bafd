#include "stages/retime/retime.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "core/config/fields.hpp"
#include "core/math/limit_report.hpp"
#include "core/math/quintic.hpp"

namespace morphe::retime {
namespace {

RobotModel robot_with(Eigen::Index joints, double velocity, double acceleration, double jerk) {
  RobotModel robot;
  robot.joint_names.assign(static_cast<std::size_t>(joints), "joint");
  robot.lower = JointVector::Constant(joints, -3);
  robot.upper = JointVector::Constant(joints, 3);
  robot.velocity = JointVector::Constant(joints, velocity);
  robot.acceleration = JointVector::Constant(joints, acceleration);
  robot.jerk = JointVector::Constant(joints, jerk);
  return robot;
}

JointPath path_of(int samples, Eigen::Index joints, double duration_s,
                  const std::function<double(double, Eigen::Index)>& position) {
  JointPath path;
  path.position.resize(samples, joints);
  for (int i = 0; i < samples; ++i) {
    const double t = samples > 1 ? duration_s * i / (samples - 1) : 0;
    path.demonstration_time.push_back(t);
    path.origin.push_back(SampleOrigin::mapped);
    for (Eigen::Index k = 0; k < joints; ++k) path.position(i, k) = position(t, k);
  }
  return path;
}

double minimum_jerk(double z) { return z * z * z * (10 - 15 * z + 6 * z * z); }

/// Everything that holds for each result; the limits are judged by dense sampling of the quintics.
void expect_valid(const RobotModel& robot, const JointPath& path,
                  const Outcome<RetimeResult>& result) {
  ASSERT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  const Trajectory& t = result.value.trajectory;
  ASSERT_GE(t.samples(), 2u);
  const Eigen::Index last = t.position.rows() - 1;
  EXPECT_EQ(t.velocity.row(0).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(t.acceleration.row(0).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(t.velocity.row(last).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(t.acceleration.row(last).cwiseAbs().maxCoeff(), 0);
  const double off_s = (t.position.row(0) - path.position.row(0)).cwiseAbs().maxCoeff();
  const double off_e =
      (t.position.row(last) - path.position.row(path.position.rows() - 1)).cwiseAbs().maxCoeff();
  EXPECT_LT(std::max(off_s, off_e), 1e-6);
  double worst[3] = {0, 0, 0};
  for (std::size_t i = 0; i + 1 < t.samples(); ++i) {
    ASSERT_NEAR(t.time[i + 1] - t.time[i], 0.002, 1e-12);
    ASSERT_GE(t.demonstration_time[i + 1], t.demonstration_time[i]);
    for (Eigen::Index k = 0; k < t.position.cols(); ++k) {
      const math::QuinticPiece piece = math::quintic_piece(t, i, k);
      for (int part = 0; part <= 8; ++part) {
        const double s = piece.duration * part / 8;
        worst[0] = std::max(worst[0], std::abs(math::value_at(piece, s, 1)) / robot.velocity[k]);
        worst[1] =
            std::max(worst[1], std::abs(math::value_at(piece, s, 2)) / robot.acceleration[k]);
        worst[2] = std::max(worst[2], std::abs(math::value_at(piece, s, 3)) / robot.jerk[k]);
        ASSERT_GE(math::value_at(piece, s), robot.lower[k]);
        ASSERT_LE(math::value_at(piece, s), robot.upper[k]);
      }
    }
  }
  EXPECT_LE(worst[0], 1);
  EXPECT_LE(worst[1], 1);
  EXPECT_LE(worst[2], 1);
}

Outcome<RetimeResult> retime_valid(const RobotModel& robot, const JointPath& path,
                                   const RetimeOptions& options = {}) {
  Outcome<RetimeResult> result = retime(robot, path, Movement{}, options);
  expect_valid(robot, path, result);
  return result;
}

TEST(Retime, StraightLineComesCloseToTheMinimumTimeAndIsNotFaster) {
  // Rest to rest under all three limits: distance / v + v / a + a / j.
  const RobotModel robot = robot_with(1, 0.99, 3.1, 31);
  const double least = 1.2 / 0.99 + 0.99 / 3.1 + 3.1 / 31;
  const JointPath line = path_of(101, 1, 1, [](double t, Eigen::Index) { return 1.2 * t; });
  const double taken = retime_valid(robot, line).value.trajectory.time.back();
  EXPECT_GE(taken, least);
  EXPECT_LE(taken, 1.03 * least);
}

TEST(Retime, HumanReachFasterThanTheRobot) {
  const RobotModel robot = robot_with(1, 0.99, 3.1, 31);
  const double least = 1.2 / 0.99 + 0.99 / 3.1 + 3.1 / 31;
  const JointPath reach =
      path_of(101, 1, 1, [](double t, Eigen::Index) { return 1.2 * minimum_jerk(t); });
  const Outcome<RetimeResult> result = retime_valid(robot, reach);
  EXPECT_GE(result.value.trajectory.time.back(), least);
  EXPECT_LE(result.value.trajectory.time.back(), 1.1 * least);
  EXPECT_LE(result.value.joint_deviation, 5e-4);
}

TEST(Retime, KeptMakesUpForWhatTheLimitsTook) {
  // Slow, then too fast for the robot for a moment, then slow again.
  const RobotModel robot = robot_with(1, 1, 10, 200);
  const JointPath path = path_of(1001, 1, 10, [](double t, Eigen::Index) {
    return 0.1 * t - 0.5 + 0.4 * std::tanh(6 * (t - 4));
  });
  RetimeOptions options;
  const double human_s = retime_valid(robot, path, options).value.trajectory.time.back();
  options.mode = RetimeMode::catch_up;
  const Trajectory kept = retime_valid(robot, path, options).value.trajectory;
  EXPECT_GT(human_s, 10.1);
  EXPECT_NEAR(kept.time.back(), 10, 0.1);
  double most_late_s = 0, late_afterwards_s = 0;
  for (std::size_t i = 0; i < kept.samples(); ++i) {
    const double late_s = kept.time[i] - kept.demonstration_time[i];
    most_late_s = std::max(most_late_s, late_s);
    if (kept.time[i] > 7 && kept.time[i] < 9.5) {
      late_afterwards_s = std::max(late_afterwards_s, std::abs(late_s));
    }
  }
  EXPECT_GT(most_late_s, 0.1);
  EXPECT_LT(late_afterwards_s, 0.02);
}

TEST(Retime, GenerousLimitsKeepTheHumanTempo) {
  const RobotModel robot = robot_with(3, 10, 100, 10000);
  const JointPath reach = path_of(121, 3, 1.2, [](double t, Eigen::Index k) {
    return (1.0 - 0.3 * static_cast<double>(k)) * minimum_jerk(t / 1.2);
  });
  const Trajectory& t = retime_valid(robot, reach).value.trajectory;

  EXPECT_DOUBLE_EQ(t.time.back(), 1.2);
  // In step with the human but for a few milliseconds, all but for the very ends.
  for (std::size_t i = 100; i + 100 < t.samples(); ++i) {
    EXPECT_NEAR(t.demonstration_time[i], t.time[i], 0.005);
  }
}

TEST(Retime, RandomSmoothPathsHoldTheirLimits) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    RobotModel robot = robot_with(22, 1.5, 10, 100);
    robot.velocity.head(2).setConstant(0.99);
    robot.acceleration.head(2).setConstant(3.1);
    robot.jerk.head(2).setConstant(31);
    std::vector<double> amplitude, phase;
    for (int k = 0; k < 44; ++k) {
      amplitude.push_back(0.15 * unit(random));
      phase.push_back(6.3 * unit(random));
    }
    const JointPath path = path_of(121, 22, 1.2, [&](double t, Eigen::Index k) {
      const auto i = static_cast<std::size_t>(k);
      return amplitude[i] * std::sin(5 * t + phase[i]) +
             0.4 * amplitude[i + 22] * std::sin(13 * t + phase[i + 22]);
    });
    const Outcome<RetimeResult> result = retime_valid(robot, path);
    EXPECT_LE(result.value.joint_deviation, 1e-3);
    EXPECT_LE(result.value.trajectory.time.back(), 2.2 * 1.2);

    RobotModel stronger = robot;
    stronger.velocity *= 2;
    stronger.acceleration *= 2;
    stronger.jerk *= 2;
    EXPECT_LT(retime_valid(stronger, path).value.trajectory.time.back(),
              result.value.trajectory.time.back());
  }
}

TEST(Retime, PolylineWithCornersSlowsDown) {
  const RobotModel robot = robot_with(2, 1, 3, 30);
  JointPath path = path_of(121, 2, 1.2, [](double t, Eigen::Index k) {
    const double turn = t < 0.6 ? 0 : t - 0.6;
    return k == 0 ? std::min(t, 0.6) : turn;
  });
  RetimeOptions exact;
  exact.joint_tolerance = 0;
  const Outcome<RetimeResult> sharp = retime_valid(robot, path, exact);
  EXPECT_LE(sharp.value.joint_deviation, 3e-5);
  const Outcome<RetimeResult> mapped = retime_valid(robot, path);
  EXPECT_LE(mapped.value.joint_deviation, 1.01e-3);
  EXPECT_LT(mapped.value.trajectory.time.back(), sharp.value.trajectory.time.back());
  // A planned stretch at one instant of the demonstration gets a clock of its own.
  path.origin.assign(path.origin.size(), SampleOrigin::planned);
  path.demonstration_time.assign(path.origin.size(), 0.5);
  const Outcome<RetimeResult> planned = retime_valid(robot, path);
  EXPECT_LE(planned.value.joint_deviation, 4.1e-3);
  EXPECT_EQ(planned.value.trajectory.origin[10], SampleOrigin::planned);
}

TEST(Retime, NoisyPathStaysWithinTolerance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-5e-4, 5e-4);
  const RobotModel robot = robot_with(2, 1, 3, 30);
  const JointPath path = path_of(121, 2, 1.2, [&](double t, Eigen::Index) {
    return 0.6 * minimum_jerk(t / 1.2) + noise(random);
  });
  const Outcome<RetimeResult> result = retime_valid(robot, path);
  EXPECT_LE(result.value.joint_deviation, 1.01e-3);
  EXPECT_LE(result.value.trajectory.time.back(), 2.2 * 1.2);
}

TEST(Retime, PathAlongAPositionLimitDoesNotLeaveIt) {
  const RobotModel robot = robot_with(1, 1, 10, 100);
  const JointPath path =
      path_of(121, 1, 1.2, [](double t, Eigen::Index) { return std::min(3.0, 2.8 + 0.5 * t); });
  retime_valid(robot, path);
}

/// The first two joints of a Franka Research 3 (libfranka), to within a hundredth of where nothing
/// of their velocity is left, and back.
TEST(Retime, AStraightWayFromLimitToLimitMeetsItsEnds) {
  RobotModel robot = robot_with(4, 2, 10, 100);
  robot.lower << -1, -1, -1, 0.2;
  robot.upper << 1, 1, 0.5, 0.5;
  JointVector from(4), to(4);
  from << -1, 1, 0.5 - 1e-7, 0.2;
  to << 1, -1 + 1e-5, 0.5, 0.2 + 2e-3;
  for (const int samples : {21, 25, 100}) {
    JointPath path = path_of(samples, 4, 0.01 * (samples - 1), [&](double t, Eigen::Index k) {
      return from[k] + (to[k] - from[k]) * t / (0.01 * (samples - 1));
    });
    path.origin.assign(path.origin.size(), SampleOrigin::planned);
    RetimeOptions options;
    options.mode = RetimeMode::fastest;
    expect_valid(robot, path, retime(robot, path, Movement{}, options));
  }
}

TEST(Retime, BrakingCurvesHoldAlongTheTrajectory) {
  RobotModel robot = robot_with(2, 2.62, 10, 5000);
  robot.braking_curves = {{0, 12, 0.3, -2.7501, 2.7501}, {1, 5.17, 0.2, -1.7918, 1.7918}};
  const JointPath path = path_of(101, 2, 1.0, [](double t, Eigen::Index k) {
    const double there = k == 0 ? 2.73 : -1.77;
    return there * minimum_jerk(t < 0.5 ? 2 * t : 2 - 2 * t);
  });
  for (const double share : {1.0, 0.6}) {
    RetimeOptions options;
    options.mode = RetimeMode::fastest;
    options.limit_scaling = share;
    const auto result = retime_valid(robot, path, options);
    const Trajectory& t = result.value.trajectory;
    double worst = 0;
    for (std::size_t i = 0; i + 1 < t.samples(); ++i) {
      for (const RobotModel::BrakingCurve& curve : robot.braking_curves) {
        for (int part = 0; part <= 8; ++part) {
          const math::QuinticPiece piece = math::quintic_piece(t, i, curve.joint);
          const double s = piece.duration * part / 8;
          const double q = math::value_at(piece, s), v = math::value_at(piece, s, 1);
          const double way = v > 0 ? curve.upper_end - q : q - curve.lower_end;
          const double left = std::sqrt(curve.twice_deceleration * way) - curve.velocity_offset;
          if (std::abs(v) > 1e-9) worst = std::max(worst, std::abs(v) / left);
        }
      }
    }
    EXPECT_LE(worst, share * (1 + 1e-9));
    EXPECT_GT(worst, 0.9 * share);  // and they are used
    EXPECT_NEAR(math::limit_report(robot, t).velocity.ratio, std::max(worst, 0.0), 0.02);
    RobotModel free = robot;
    free.braking_curves.clear();
    EXPECT_LT(retime_valid(free, path, options).value.trajectory.time.back(), t.time.back());
  }
}

TEST(Retime, DegeneratePathsStandStill) {
  const RobotModel robot = robot_with(3, 1, 3, 30);
  const auto still = [](double, Eigen::Index k) { return 0.1 * static_cast<double>(k); };
  const Trajectory rest = retime_valid(robot, path_of(121, 3, 1.2, still)).value.trajectory;
  EXPECT_NEAR(rest.time.back(), 1.2, 0.05);
  EXPECT_LT((rest.position.rowwise() - rest.position.row(0)).cwiseAbs().maxCoeff(), 1e-12);
  retime_valid(robot, path_of(2, 3, 0, still));
  retime_valid(robot, path_of(1, 3, 0, still));
}

TEST(Retime, TwoSamplesAndDuplicates) {
  const RobotModel robot = robot_with(2, 1, 3, 30);
  const auto line = [](double t, Eigen::Index k) { return k == 0 ? t : 0.3 * t; };
  retime_valid(robot, path_of(2, 2, 0.8, line));
  JointPath path = path_of(81, 2, 0.8, line);
  for (std::size_t i = 31; i < 36; ++i) {
    path.demonstration_time[i] = path.demonstration_time[30];
    path.position.row(static_cast<Eigen::Index>(i)) = path.position.row(30);
  }
  retime_valid(robot, path);
}

TEST(Retime, AStretchWhereDemonstrationTimeStandsStill) {
  const RobotModel robot = robot_with(2, 1, 3, 30);
  JointPath path = path_of(121, 2, 1.2, [](double t, Eigen::Index k) {
    return k == 0 ? 0.5 * minimum_jerk(t / 1.2) : 0.2 * std::sin(3 * t);
  });
  for (std::size_t i = 40; i < 80; ++i) {
    path.demonstration_time[i] = 0.4;
    path.origin[i] = SampleOrigin::planned;
  }
  for (std::size_t i = 80; i < 121; ++i) path.demonstration_time[i] -= 0.39;
  retime_valid(robot, path);
}

TEST(Retime, PhasesFollowTheDemonstration) {
  const RobotModel robot = robot_with(1, 1, 3, 30);
  Movement movement;
  movement.phases = {{PhaseKind::reach, 0, 0.6, 1}, {PhaseKind::grasp, 0.6, 1.2, 1}};
  const JointPath path =
      path_of(121, 1, 1.2, [](double t, Eigen::Index) { return 0.5 * minimum_jerk(t / 1.2); });
  const Trajectory t = retime(robot, path, movement, {}).value.trajectory;
  EXPECT_EQ(t.phase.front(), PhaseKind::reach);
  EXPECT_EQ(t.phase.back(), PhaseKind::grasp);
  EXPECT_TRUE(std::isnan(t.clearance[3]));
  EXPECT_DOUBLE_EQ(t.demonstration_time.back(), 1.2);
}

TEST(Retime, TheLastSampleIsInThePhaseThatEndsThere) {
  const RobotModel robot = robot_with(1, 1, 3, 30);
  const JointPath path =
      path_of(121, 1, 1.2, [](double t, Eigen::Index) { return 0.5 * minimum_jerk(t / 1.2); });
  for (const double rounding : {-1e-15, 0.0, 1e-15}) {
    Movement movement;
    movement.end_s = 1.2 + rounding;
    movement.phases = {{PhaseKind::reach, 0, 0.6, 1},
                       {PhaseKind::grasp, 0.6, movement.end_s, 1},
                       {PhaseKind::transport, movement.end_s, 1.4, 1}};
    EXPECT_EQ(retime(robot, path, movement, {}).value.trajectory.phase.back(), PhaseKind::grasp);
  }
}

TEST(Retime, RefusesWhatIsNoPath) {
  const RobotModel robot = robot_with(2, 1, 3, 30);
  const auto line = [](double t, Eigen::Index) { return t; };
  EXPECT_EQ(retime(robot, JointPath{}, {}, {}).failure.reason, Reason::invalid_path);
  JointPath path = path_of(11, 2, 1, line);
  path.position(3, 1) = kUnknown;
  EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::invalid_path);
  path = path_of(11, 2, 1, line);
  path.demonstration_time[5] = 0;
  EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::invalid_path);
  path = path_of(11, 2, 1, line);
  path.position(4, 0) = 3.01;
  EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::joint_limit);
}

TEST(Retime, FastestComesCloseToTheClosedFormAfterSampling) {
  RetimeOptions options;
  options.mode = RetimeMode::fastest;
  RobotModel robot = robot_with(1, 0.99, 3.1, std::numeric_limits<double>::infinity());
  const JointPath line = path_of(101, 1, 30, [](double t, Eigen::Index) { return t / 25; });
  const double trapezoid = 1.2 / 0.99 + 0.99 / 3.1;
  const double without = retime_valid(robot, line, options).value.trajectory.time.back();
  EXPECT_GE(without, trapezoid);
  EXPECT_LE(without, 1.02 * trapezoid);
  robot.jerk.setConstant(31);
  const double with = retime_valid(robot, line, options).value.trajectory.time.back();
  EXPECT_GE(with, trapezoid + 3.1 / 31);
  EXPECT_LE(with, 1.03 * (trapezoid + 3.1 / 31));
}

TEST(Retime, ADurationIsMetOrRefused) {
  const RobotModel robot = robot_with(2, 1, 3, 30);
  const JointPath path = path_of(121, 2, 1.2, [](double t, Eigen::Index k) {
    return (k == 0 ? 0.6 : -0.4) * minimum_jerk(t / 1.2);
  });
  RetimeOptions options;
  options.mode = RetimeMode::fastest;
  const double least = retime_valid(robot, path, options).value.trajectory.time.back();
  options.mode = RetimeMode::duration;
  for (const double duration_s : {1.03 * least, 2 * least, 10.0}) {
    options.duration_s = duration_s;
    EXPECT_NEAR(retime_valid(robot, path, options).value.trajectory.time.back(), duration_s, 0.002);
  }
  options.duration_s = 0.9 * least;
  EXPECT_EQ(retime(robot, path, Movement{}, options).failure.reason, Reason::duration_too_short);
}

TEST(Retime, AnyDurationFromTheFastestOnIsMet) {
  // Straight lines from waypoint to waypoint: nothing but corners.
  const double waypoint[] = {0.499, 0.301, 0.070, 0.113, 0.145, -0.081, -0.265, -0.292};
  const RobotModel robot = robot_with(1, 0.6889, 5.303, 239.8);
  const JointPath path = path_of(8, 1, 2.36, [&](double t, Eigen::Index) {
    return waypoint[static_cast<std::size_t>(std::lround(t / 2.36 * 7))];
  });
  RetimeOptions options;
  options.mode = RetimeMode::fastest;
  const double least = retime_valid(robot, path, options).value.trajectory.time.back();
  options.mode = RetimeMode::duration;
  for (const double times : {1.0, 1.003, 1.03, 1.2, 4.0}) {
    SCOPED_TRACE(times);
    options.duration_s = times * least;
    EXPECT_NEAR(retime_valid(robot, path, options).value.trajectory.time.back(), times * least,
                0.002);
  }
}

TEST(Retime, APhaseIsSlowerByItsScale) {
  const RobotModel robot = robot_with(1, 1, 3, 30);
  Movement movement;
  movement.phases = {{PhaseKind::reach, 0, 1.5}, {PhaseKind::grasp, 1.5, 3}};
  const JointPath path = path_of(301, 1, 3, [](double t, Eigen::Index) { return 0.2 * t; });
  RetimeOptions options;
  options.phase_speed = {{PhaseKind::grasp, 0.5}};
  const Trajectory t = retime(robot, path, movement, options).value.trajectory;
  ASSERT_GT(t.samples(), 2u);
  double fastest[2] = {0, 0};
  for (std::size_t i = 0; i < t.samples(); ++i) {
    double& here = fastest[t.phase[i] == PhaseKind::grasp];
    if (std::abs(t.demonstration_time[i] - 1.5) < 0.02) continue;
    here = std::max(here, t.velocity(static_cast<Eigen::Index>(i), 0));
  }
  EXPECT_NEAR(fastest[0], 0.2, 0.01);
  EXPECT_NEAR(fastest[1], 0.1, 0.005);
}

TEST(Retime, ATipIsNoFasterThanItsLimit) {
  RobotModel robot = robot_with(1, 1, 3, 30);
  RobotModel::Frame frame;
  frame.joint = 0;
  robot.frames.push_back(frame);
  RobotModel::Tip tip;
  tip.transform.translation() = Vec3(0.5, 0, 0);
  robot.tips.push_back(tip);
  const JointPath path =
      path_of(121, 1, 1.2, [](double t, Eigen::Index) { return 0.6 * minimum_jerk(t / 1.2); });
  RetimeOptions options;
  options.max_tip_speed = 0.1;
  const Trajectory t = retime_valid(robot, path, options).value.trajectory;
  EXPECT_NEAR(t.velocity.maxCoeff() * 0.5, 0.1, 1e-3);
}

TEST(Retime, PausesAreKeptUnlessItShallBeFast) {
  const RobotModel robot = robot_with(1, 1, 3, 30);
  const auto pausing = [](double t, Eigen::Index) {
    return 0.3 * (minimum_jerk(std::min(t, 1.0)) + minimum_jerk(std::clamp(t - 2, 0.0, 1.0)));
  };
  const JointPath path = path_of(301, 1, 3, pausing);
  RetimeOptions options;
  EXPECT_NEAR(retime_valid(robot, path, options).value.trajectory.time.back(), 3, 0.1);
  options.mode = RetimeMode::fastest;
  EXPECT_LT(retime_valid(robot, path, options).value.trajectory.time.back(), 2);
}

TEST(Retime, LimitsThatAreNoneAreNone) {
  const JointPath path =
      path_of(121, 1, 1.2, [](double t, Eigen::Index) { return 0.5 * minimum_jerk(t / 1.2); });
  const double infinity = std::numeric_limits<double>::infinity();
  const RobotModel free = robot_with(1, infinity, infinity, infinity);
  EXPECT_NEAR(retime_valid(free, path).value.trajectory.time.back(), 1.2, 0.003);
  for (const double bad : {0.0, -1.0, kUnknown}) {
    RobotModel robot = robot_with(1, 1, 3, 30);
    robot.acceleration[0] = bad;
    EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::joint_limit);
    robot = robot_with(1, 1, bad, 30);
    EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::joint_limit);
    robot = robot_with(1, 1, 3, 30);
    robot.upper[0] = kUnknown;
    EXPECT_EQ(retime(robot, path, {}, {}).failure.reason, Reason::joint_limit);
  }
}

TEST(Retime, OptionsAreReadAndChecked) {
  RetimeOptions options;
  config::read_options(
      config::ConfigNode::parse("{sample_rate_hz: 250, limit_scaling: 0.8, max_tip_speed: 0.5, "
                                "phase_speed: [{phase: grasp, scale: 0.5}]}",
                                "x"),
      options);
  EXPECT_EQ(options.sample_rate_hz, 250);
  EXPECT_EQ(options.limit_scaling, 0.8);
  EXPECT_EQ(options.max_tip_speed, 0.5);
  EXPECT_EQ(options.phase_speed.front().phase, PhaseKind::grasp);
  const auto error_of = [](const std::string& yaml) -> std::string {
    RetimeOptions other;
    try {
      config::read_options(config::ConfigNode::parse(yaml, "x"), other);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of("{limit_scaling: 1.5}"),
            "x:1: limit_scaling: must be at least 0.001 and at most 1, not 1.5");
  EXPECT_EQ(error_of("{mode: quick}"),
            "x:1: mode: must be human, fastest, duration or catch_up, not 'quick'");
  EXPECT_EQ(error_of("{mode: duration}"),
            "x:1: duration_s must be given with mode duration, and only with it");
  EXPECT_EQ(error_of("{duration_s: 2}"),
            "x:1: duration_s: must be given with mode duration, and only with it");
  EXPECT_EQ(error_of("{phase_speed: [{phase: lunch, scale: 1}]}"),
            "x:1: phase_speed[0].phase: must be rest, reach, preshape, grasp, hold, transport, "
            "return, approach, lift, place, release, retreat or home, not 'lunch'");
  EXPECT_EQ(error_of("{max_tip_speed: 0}"),
            "x:1: max_tip_speed: must be at least 0.001 and at most 100 m/s, not 0");
}

}  // namespace
}  // namespace morphe::retime
