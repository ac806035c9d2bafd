#include "stages/export/resample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/input_error.hpp"
#include "stages/export/joint_group.hpp"

namespace morphe::exports {
namespace {

/// t^5 - 2 t^3 and -t^5 + t, sampled: quintics between the samples give them back exactly.
constexpr std::array<std::array<double, 6>, 2> kCurves = {
    {{0, 0, 0, -2, 0, 1}, {0, 1, 0, 0, 0, -1}}};

double curve(std::size_t joint, double t, int order) {
  double value = 0;
  for (int k = order; k < 6; ++k) {
    double factor = kCurves[joint][static_cast<std::size_t>(k)];
    for (int d = 0; d < order; ++d) factor *= k - d;
    value += factor * std::pow(t, k - order);
  }
  return value;
}

Trajectory sampled(const std::vector<double>& time) {
  Trajectory t;
  const auto rows = static_cast<Eigen::Index>(time.size());
  t.position = t.velocity = t.acceleration = JointRows::Zero(rows, 2);
  t.time = time;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto joint = static_cast<Eigen::Index>(j);
      t.position(row, joint) = curve(j, time[i], 0);
      t.velocity(row, joint) = curve(j, time[i], 1);
      t.acceleration(row, joint) = curve(j, time[i], 2);
    }
    t.demonstration_time.push_back(2 * time[i]);
    t.phase.push_back(i < 2 ? PhaseKind::rest : PhaseKind::reach);
    t.origin.push_back(SampleOrigin::mapped);
    t.clearance.push_back(0.1);
  }
  return t;
}

TEST(Resampled, LiesOnTheCurveAtAnyRate) {
  const Trajectory samples = sampled({0, 0.1, 0.35, 0.6, 0.97});
  for (const double rate_hz : {1000.0, 333.0, 70.0, 10.0, 1.0}) {
    const Trajectory t = resample(samples, rate_hz);
    EXPECT_EQ(t.time.back(), 0.97);
    for (std::size_t i = 0; i < t.samples(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (i + 1 < t.samples()) {
        EXPECT_EQ(t.time[i], static_cast<double>(i) / rate_hz);
      }
      EXPECT_NEAR(t.demonstration_time[i], 2 * t.time[i], 1e-12);
      EXPECT_EQ(t.phase[i], t.time[i] < 0.35 ? PhaseKind::rest : PhaseKind::reach);
      for (std::size_t j = 0; j < 2; ++j) {
        const auto joint = static_cast<Eigen::Index>(j);
        EXPECT_NEAR(t.position(row, joint), curve(j, t.time[i], 0), 1e-12);
        EXPECT_NEAR(t.velocity(row, joint), curve(j, t.time[i], 1), 1e-11);
        EXPECT_NEAR(t.acceleration(row, joint), curve(j, t.time[i], 2), 1e-10);
      }
    }
  }
}

TEST(Resampled, TheEndIsThereOnce) {
  const Trajectory samples = sampled({0, 0.25, 0.5});
  EXPECT_EQ(resample(samples, 8).time, (std::vector<double>{0, 0.125, 0.25, 0.375, 0.5}));
  EXPECT_EQ(resample(samples, 3).time, (std::vector<double>{0, 1.0 / 3, 0.5}));
  // A point a rounding before the end is the end.
  EXPECT_EQ(resample(sampled({0, 0.25, 0.5 + 1e-12}), 2).time,
            (std::vector<double>{0, 0.5 + 1e-12}));
}

TEST(ResampledUniformly, IsExactlyAtKOverRate) {
  const Trajectory from = sampled({0, 0.2, 0.5, 0.61});
  for (const double rate_hz : {20.0, 30.0, 50.0, 7.0, 1.0, 1000.0}) {
    const Trajectory to = resample_uniformly(from, rate_hz);
    const std::size_t last = to.samples() - 1;
    EXPECT_NEAR(static_cast<double>(last), std::ceil(0.61 * rate_hz - 1e-6), 1e-9) << rate_hz;
    for (std::size_t k = 0; k <= last; ++k) {
      EXPECT_EQ(to.time[k], static_cast<double>(k) / rate_hz);
      for (std::size_t j = 0; j < 2 && k < last; ++j) {
        const auto row = static_cast<Eigen::Index>(k), joint = static_cast<Eigen::Index>(j);
        EXPECT_NEAR(to.position(row, joint), curve(j, to.time[k], 0), 1e-12);
        EXPECT_NEAR(to.velocity(row, joint), curve(j, to.time[k], 1), 1e-11);
      }
    }
    EXPECT_EQ(to.position.bottomRows(1), from.position.bottomRows(1));
    EXPECT_EQ(to.velocity.bottomRows(1).norm(), 0);
    EXPECT_EQ(to.phase.size(), to.samples());
  }
}

TEST(Subdivided, KeepsTheSamplesAndTheCurve) {
  const Trajectory samples = sampled({0.2, 0.3, 0.55, 0.8, 1.17});
  const Trajectory t = subdivide(samples, 3);
  ASSERT_EQ(t.samples(), 13u);
  for (int i = 0; i < 13; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const auto joint = static_cast<Eigen::Index>(j);
      EXPECT_NEAR(t.position(i, joint), curve(j, t.time[i], 0), 1e-12);
      EXPECT_NEAR(t.acceleration(i, joint), curve(j, t.time[i], 2), 1e-10);
    }
    if (i % 3 != 0) continue;
    EXPECT_EQ(t.time[i], samples.time[i / 3]);
    EXPECT_EQ(t.position.row(i), samples.position.row(i / 3));
    EXPECT_EQ(t.velocity.row(i), samples.velocity.row(i / 3));
    EXPECT_EQ(t.acceleration.row(i), samples.acceleration.row(i / 3));
  }
  EXPECT_EQ(subdivide(samples, 1).time, samples.time);
}

TEST(Delayed, WaitsInTheFirstPosture) {
  const Trajectory t = add_initial_wait(sampled({0, 0.5}), 0.25);
  EXPECT_EQ(t.time, (std::vector<double>{0, 0.25, 0.75}));
  EXPECT_EQ(t.position.row(0), t.position.row(1));
  EXPECT_TRUE(t.velocity.row(0).isZero(0));
}

TEST(Joined, TheWayEndsExactlyWhereTheMotionBegins) {
  const Trajectory way = sampled({0, 0.2, 0.4});
  Trajectory motion = sampled({0.4, 0.6, 0.8});
  motion.position.row(0).array() += 1e-7;
  motion.velocity.row(0).array() -= 1e-6;
  motion.acceleration.row(0).array() += 1e-4;
  const Trajectory led = adjust_end(way, motion);
  EXPECT_LT((led.position.row(2) - motion.position.row(0)).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((led.velocity.row(2) - motion.velocity.row(0)).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((led.acceleration.row(2) - motion.acceleration.row(0)).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(led.position.row(0), way.position.row(0));
  const Trajectory both = concatenate(led, motion);
  EXPECT_EQ(both.samples(), 5u);
  EXPECT_NEAR(both.time.back(), 0.8, 1e-15);
  const Trajectory back = adjust_begin(sampled({0, 0.2, 0.4}), both);
  EXPECT_LT((back.position.row(0) - both.position.row(4)).cwiseAbs().maxCoeff(), 1e-15);
}

RobotModel arm_and_finger() {
  RobotModel robot;
  robot.name = "two";
  robot.joint_names = {"shoulder", "finger"};
  robot.frames.resize(3);
  robot.frames[0] = {"shoulder", -1, Pose::Identity(), Vec3::UnitZ(), 0};
  robot.frames[1] = {"palm", 0, Pose::Identity(), Vec3::UnitZ(), -1};
  robot.frames[2] = {"finger", 1, Pose::Identity(), Vec3::UnitX(), 1, 1, 0, true};
  robot.palm_frame = 1;
  return robot;
}

TEST(JointGroup, ArmAndHandAreAll) {
  const RobotModel robot = arm_and_finger();
  EXPECT_EQ(joint_group(robot, "arm").joints, std::vector<int>{0});
  EXPECT_EQ(joint_group(robot, "hand").joints, std::vector<int>{1});
  EXPECT_EQ(joint_group(robot, "hand").units, std::vector<std::string>{"m"});
  EXPECT_EQ(joint_group(robot, "all").joints, (std::vector<int>{0, 1}));
  RobotModel wristed = robot;
  wristed.joint_names = {"shoulder", "wrist", "finger"};
  wristed.frames.insert(wristed.frames.begin() + 1,
                        {{"flange", 0, Pose::Identity(), Vec3::UnitZ(), -1},
                         {"wrist", 1, Pose::Identity(), Vec3::UnitZ(), 1}});
  wristed.frames[3].parent = 2;
  wristed.frames[4] = {"finger", 3, Pose::Identity(), Vec3::UnitX(), 2, 1, 0, true};
  wristed.palm_frame = 3;
  EXPECT_EQ(joint_group(wristed, "arm").joints, std::vector<int>{0});
  EXPECT_EQ(joint_group(wristed, "hand").joints, (std::vector<int>{1, 2}));
  EXPECT_EQ(joint_group(robot, "mine=shoulder..finger").name, "mine");
  const auto error_of = [&](const std::string& asked) -> std::string {
    try {
      joint_group(robot, asked);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of("mine=finger..shoulder"),
            "--group mine=finger..shoulder: 'finger' comes after 'shoulder': swap them");
  EXPECT_THAT(error_of("leg"), testing::StartsWith("--group leg: must be "));
}

}  // namespace
}  // namespace morphe::exports
