#include "core/human/arm_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/expect_near.hpp"

namespace morphe::human {
namespace {

constexpr double kPi = std::numbers::pi;
const ArmLengths kLengths{0.30, 0.25};
const Vec3 kShoulderAt(0.2, -0.1, 0.4);

ArmPose pose_of(const ArmAngles& degrees) {
  ArmAngles angles;
  for (std::size_t k = 0; k < kArmAngleCount; ++k) angles[k] = degrees[k] * kRadPerDegree;
  return arm_pose(kShoulderAt, kLengths, angles);
}

ArmAngles random_angles(std::mt19937& random, double inside) {
  ArmAngles angles;
  for (std::size_t k = 0; k < kArmAngleCount; ++k) {
    std::uniform_real_distribution<double> uniform(human_arm_limits().lower[k] + inside,
                                                   human_arm_limits().upper[k] - inside);
    angles[k] = uniform(random);
  }
  return angles;
}

void expect_within_limits(const ArmAngles& angles) {
  for (std::size_t k = 0; k < kArmAngleCount; ++k) {
    EXPECT_GE(angles[k], human_arm_limits().lower[k]);
    EXPECT_LE(angles[k], human_arm_limits().upper[k]);
  }
}

TEST(ArmPose, HangsAtZeroWithTheThumbToTheFront) {
  const ArmPose pose = pose_of({});
  expect_near(pose.elbow, kShoulderAt - Vec3(0, 0, 0.30));
  expect_near(pose.wrist, kShoulderAt - Vec3(0, 0, 0.55));
  expect_near(pose.world_from_hand * Vec3::UnitZ(), -Vec3::UnitZ());  // fingers
  expect_near(pose.world_from_hand * Vec3::UnitY(), Vec3::UnitY());   // thumb
  expect_near(pose.world_from_hand * Vec3::UnitX(), -Vec3::UnitX());  // palm to the thigh
}

TEST(ArmPose, EachAngleTurnsAsItsNameSays) {
  const auto fingers = [](const ArmPose& p) -> Vec3 { return p.world_from_hand * Vec3::UnitZ(); };
  const auto palm = [](const ArmPose& p) -> Vec3 { return p.world_from_hand * Vec3::UnitX(); };
  expect_near(pose_of({90}).wrist, kShoulderAt + Vec3(0, 0.55, 0));
  expect_near(pose_of({0, 90}).wrist, kShoulderAt + Vec3(0.55, 0, 0));
  expect_near(pose_of({0, 0, 90, 90}).wrist, kShoulderAt + Vec3(-0.25, 0, -0.30));
  expect_near(pose_of({0, 0, 0, 90}).wrist, kShoulderAt + Vec3(0, 0.25, -0.30));
  expect_near(palm(pose_of({0, 0, 0, 90, 0})), -Vec3::UnitX());
  expect_near(palm(pose_of({0, 0, 0, 90, 70})),  // nearly palm down
              Vec3(-std::cos(70 * kRadPerDegree), 0, -std::sin(70 * kRadPerDegree)));
  expect_near(fingers(pose_of({0, 0, 0, 90, 0, 90})), -Vec3::UnitX());    // to the palm
  expect_near(fingers(pose_of({0, 0, 0, 90, 0, 0, 90})), Vec3::UnitZ());  // to the thumb
}

/// The same arm as one product of homogeneous matrices, written out joint by joint.
TEST(ArmPose, IsTheProductOfItsJoints) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const ArmAngles q = random_angles(random, 0);
    const auto about = [](const Vec3& axis, double angle) {
      return Pose(Eigen::AngleAxisd(angle, axis));
    };
    Pose pose = Pose(Eigen::Translation3d(kShoulderAt)) * about(Vec3::UnitX(), q[0]) *
                about(Vec3::UnitY(), -q[1]) * about(Vec3::UnitZ(), q[2]) *
                Eigen::Translation3d(0, 0, -kLengths.upper_arm);
    const ArmPose arm = arm_pose(kShoulderAt, kLengths, q);
    expect_near(arm.elbow, pose.translation());
    pose = pose * about(Vec3::UnitX(), q[3]) * Eigen::Translation3d(0, 0, -kLengths.forearm) *
           about(Vec3::UnitZ(), q[4]) * about(Vec3::UnitY(), q[5]) * about(Vec3::UnitX(), q[6]);
    expect_near(arm.wrist, pose.translation());
    pose = pose * about(Vec3::UnitY(), kPi);
    EXPECT_LT(angle_between(arm.world_from_hand, Quat(pose.linear())), 1e-7);
  }
}

TEST(FitArmAngles, FindsTheAnglesOfEveryPose) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 5000; ++trial) {
    const ArmAngles q = random_angles(random, 1e-3);
    const ArmFit fit = fit_arm_angles(arm_pose(kShoulderAt, kLengths, q));
    EXPECT_LT(fit.position_error_m, 1e-9);
    EXPECT_LT(fit.rotation_error_rad, 1e-7);
    for (std::size_t k = 0; k < kArmAngleCount; ++k) EXPECT_NEAR(fit.angles[k], q[k], 1e-6) << k;
  }
}

TEST(FitArmAngles, StraightElbowsAndArmsToTheSideKeepTheirPose) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 1000; ++trial) {
    ArmAngles q = random_angles(random, 1e-3);
    if (trial % 2 == 0) {
      q[3] = 0;
    } else {
      q[1] = kPi / 2;
    }
    const ArmFit fit = fit_arm_angles(arm_pose(kShoulderAt, kLengths, q));
    expect_within_limits(fit.angles);
    EXPECT_LT(fit.position_error_m, 1e-7);
    EXPECT_LT(fit.rotation_error_rad, 1e-6) << trial;
  }
}

TEST(FitArmAngles, StaysWithinLimitsAndSaysWhatItMissesBy) {
  const ArmFit outwards = fit_arm_angles(pose_of({0, 0, -54, 90}));  // 20 degrees too far
  expect_within_limits(outwards.angles);
  EXPECT_NEAR(outwards.angles[2], -34 * kRadPerDegree, 1e-12);
  EXPECT_NEAR(outwards.position_error_m, 2 * 0.25 * std::sin(10 * kRadPerDegree), 1e-12);
  const ArmFit beyond = fit_arm_angles(pose_of({0, 0, 0, 90, 97}));
  EXPECT_NEAR(beyond.angles[4], 77 * kRadPerDegree, 1e-9);
  EXPECT_NEAR(beyond.position_error_m, 0, 1e-12);
  EXPECT_NEAR(beyond.rotation_error_rad, 20 * kRadPerDegree, 1e-9);
  const ArmFit backwards = fit_arm_angles(pose_of({0, 0, 0, -5}));
  expect_within_limits(backwards.angles);  // an elbow bent the wrong way is best held straight
  EXPECT_NEAR(backwards.angles[3], 0, 1 * kRadPerDegree);
  EXPECT_NEAR(backwards.position_error_m, 2 * 0.25 * std::sin(2.5 * kRadPerDegree), 0.0005);

  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (int trial = 0; trial < 1000; ++trial) {
    ArmPose pose{kShoulderAt, kShoulderAt + 0.3 * any().normalized(), Vec3::Zero(),
                 Quat(normal(random), normal(random), normal(random), normal(random)).normalized()};
    pose.wrist = pose.elbow + 0.25 * any().normalized();
    const ArmFit fit = fit_arm_angles(pose);
    expect_within_limits(fit.angles);
    const ArmPose reached = arm_pose(kShoulderAt, {0.3, 0.25}, fit.angles);
    EXPECT_NEAR(fit.position_error_m,
                std::max((reached.elbow - pose.elbow).norm(), (reached.wrist - pose.wrist).norm()),
                1e-9);
    EXPECT_NEAR(fit.rotation_error_rad,
                angle_between(reached.world_from_hand, pose.world_from_hand), 1e-6);
  }
}

TEST(FitArmAngles, AreUnseenWhereThePoseIs) {
  ArmPose pose = pose_of({10, 10, 10, 90});
  for (const auto& spoil :
       {+[](ArmPose& p) { p.wrist.x() = kUnknown; }, +[](ArmPose& p) { p.shoulder.z() = kUnknown; },
        +[](ArmPose& p) { p.world_from_hand = unknown_rotation(); },
        +[](ArmPose& p) { p.elbow = p.shoulder; }}) {
    ArmPose spoiled = pose;
    spoil(spoiled);
    const ArmFit fit = fit_arm_angles(spoiled);
    for (const double angle : fit.angles) EXPECT_TRUE(std::isnan(angle));
    EXPECT_TRUE(std::isnan(fit.position_error_m));
  }
}

}  // namespace
}  // namespace morphe::human
