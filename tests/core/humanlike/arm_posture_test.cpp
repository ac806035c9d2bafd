#include "core/humanlike/arm_posture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/humanlike/arm_headroom.hpp"

namespace morphe::humanlike {
namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Matrix3d rotation(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// An arm along z of which the elbow is turned about z by an angle from x.
ArmPoints bent_arm(double upper_arm, double forearm, double line, double swivel) {
  const double along = (upper_arm * upper_arm + line * line - forearm * forearm) / (2 * line);
  const double beside = std::sqrt(upper_arm * upper_arm - along * along);
  return {Vec3::Zero(), Vec3(beside * std::cos(swivel), beside * std::sin(swivel), along),
          Vec3(0, 0, line)};
}

ArmPoints moved(const ArmPoints& arm, const Eigen::Matrix3d& turn, const Vec3& shift) {
  return {turn * arm.shoulder + shift, turn * arm.elbow + shift, turn * arm.wrist + shift};
}

TEST(ArmPosture, SwivelAngleIsTheTurnOfTheElbowForAnySizeAndPlace) {
  for (const double swivel : {-3.1, -1.0, 0.0, 0.3, 2.5}) {
    const ArmPoints human = bent_arm(0.28, 0.25, 0.4, 0.7);
    const ArmPoints robot = bent_arm(0.45, 0.48, 0.6, 0.7 + swivel);
    EXPECT_NEAR(swivel_error(human, robot), swivel, 1e-12);
    EXPECT_NEAR(swivel_error(robot, human), -swivel, 1e-12);
    // The shortest rotation that lays z on another line turns about their common perpendicular.
    const Eigen::Matrix3d turn = rotation(1.2, Vec3(0.6, -0.8, 0));
    EXPECT_NEAR(swivel_error(human, moved(robot, turn, Vec3(1, -2, 0.5))), swivel, 1e-12);
  }
}

TEST(ArmPosture, SwivelAngleIsUnknownOfAStretchedArmAndOfOppositeLines) {
  const ArmPoints bent = bent_arm(0.3, 0.3, 0.4, 0), almost_straight = bent_arm(0.3, 0.3, 0.59, 0);
  EXPECT_LT(almost_straight.elbow.x(), kMinElbowOffsetShare * 0.6);
  EXPECT_TRUE(std::isnan(swivel_error(bent, almost_straight)));
  EXPECT_TRUE(std::isnan(swivel_error(almost_straight, bent)));
  EXPECT_TRUE(
      std::isnan(swivel_error(bent, moved(bent, rotation(1.6, Vec3::UnitX()), Vec3::Zero()))));
  EXPECT_TRUE(std::isnan(swivel_error(bent, ArmPoints{})));
}

TEST(ArmPosture, DirectionErrorIsExactAtBothEnds) {
  EXPECT_NEAR(direction_error(Vec3(2, 0, 0), Vec3(std::cos(1e-9), std::sin(1e-9), 0)), 1e-9, 1e-15);
  EXPECT_NEAR(direction_error(Vec3(2, 0, 0), Vec3(-1, 0, 0)), kPi, 1e-15);
}

TEST(ArmHeadroom, LeastAnglesAreThoseOfAllPlacesOnTheCircle) {
  const ArmPoints human =
      moved(bent_arm(0.28, 0.25, 0.4, 1), rotation(0.4, Vec3(1, 2, 3)), Vec3::Zero());
  const LeastDirectionErrors least = least_direction_errors(human, bent_arm(0.45, 0.48, 0.6, 0));
  double upper_arm = kPi, forearm = kPi;
  constexpr int kPlaces = 20000;
  for (int k = 0; k < kPlaces; ++k) {
    const ArmPoints robot = bent_arm(0.45, 0.48, 0.6, 2 * kPi * k / kPlaces);
    upper_arm = std::min(
        upper_arm, direction_error(human.elbow - human.shoulder, robot.elbow - robot.shoulder));
    forearm =
        std::min(forearm, direction_error(human.wrist - human.elbow, robot.wrist - robot.elbow));
  }
  EXPECT_GT(least.upper_arm, 0.1);
  EXPECT_NEAR(least.upper_arm, upper_arm, 1e-6);
  EXPECT_NEAR(least.forearm, forearm, 1e-6);
}

TEST(ArmHeadroom, WristOffsetIsWhatWasAddedToAnArmOfTheSameDirections) {
  const ArmPoints human = bent_arm(0.28, 0.25, 0.4, 1);
  const Vec3 elbow = 0.45 * human.elbow.normalized();
  const Vec3 wrist = elbow + 0.48 * (human.wrist - human.elbow).normalized();
  // A link along the line to a wrist elsewhere has the same length only about that line.
  const ArmPoints robot{Vec3(1, 1, 1), Vec3(1, 1, 1) + elbow, Vec3(1, 1, 1) + wrist};
  EXPECT_LT(wrist_offset(human, robot).norm(), 1e-15);
  EXPECT_FALSE(is_known(wrist_offset(ArmPoints{}, robot)));
  const Eigen::Matrix3d turn = rotation(0.3, human.wrist);
  const ArmPoints turned = moved(robot, turn, Vec3::Zero());
  EXPECT_LT((wrist_offset(human, turned) - (turn - Eigen::Matrix3d::Identity()) * wrist).norm(),
            1e-14);
}

}  // namespace
}  // namespace morphe::humanlike
