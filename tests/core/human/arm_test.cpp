#include "core/human/arm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace morphe::human {
namespace {

const ArmLengths kArm{0.30, 0.25};

TEST(NaturalElbow, KeepsBothLengthsAndIsTheCirclesPointFurthestAlong) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vec3 wanted(0, -2, -1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 shoulder(uniform(random), uniform(random), uniform(random));
    const Vec3 direction = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    const Vec3 wrist = shoulder + direction * (0.3 + 0.2 * std::abs(uniform(random)));
    const Vec3 turned = elbow_from_swivel(shoulder, wrist, kArm, 0.3);
    EXPECT_NEAR((turned - shoulder).norm(), kArm.upper_arm, 1e-12);
    EXPECT_NEAR((turned - wrist).norm(), kArm.forearm, 1e-12);
    const Vec3 elbow = elbow_from_swivel(shoulder, wrist, kArm, 0.0);
    for (int step = 1; step < 36; ++step) {  // no other swivel is further along
      const Eigen::AngleAxisd swivel(step * std::numbers::pi / 18, direction);
      const Vec3 other = shoulder + swivel * (elbow - shoulder);
      EXPECT_LE(wanted.dot(other), wanted.dot(elbow) + 1e-12);
    }
  }
}

TEST(NaturalElbow, HangsBelowAheadAndBehindWhenTheHandIsBelow) {
  const Vec3 shoulder(0.2, 0, 0.4);
  const double outward = 0.3;
  const Vec3 ahead =
      elbow_from_swivel(shoulder, shoulder + Vec3(0, 0.4, 0), kArm, outward) - shoulder;
  EXPECT_LT(ahead.z(), 0);
  EXPECT_NEAR(std::atan2(ahead.x(), -ahead.z()), outward, 1e-12);
  const Vec3 below =
      elbow_from_swivel(shoulder, shoulder - Vec3(0, 0, 0.4), kArm, outward) - shoulder;
  EXPECT_LT(below.y(), 0);
  EXPECT_GT(below.x(), 0);
}

TEST(NaturalElbow, StraightensWhenOutOfReachAndIsUnseenWithoutWrist) {
  const Vec3 shoulder(0.2, 0, 0.4);
  const Vec3 far = elbow_from_swivel(shoulder, shoulder + Vec3(0, 2, 0), kArm, 0.3);
  EXPECT_LT((far - shoulder - Vec3(0, 0.30, 0)).norm(), 1e-7);
  EXPECT_FALSE(is_known(elbow_from_swivel(shoulder, unknown_point(), kArm, 0.3)));
  EXPECT_FALSE(is_known(elbow_from_swivel(shoulder, shoulder, kArm, 0.3)));
}

TEST(ShoulderWithinReach, StaysWhereItMayAndMovesWhereItMust) {
  const Vec3 wanted(0, -0.2, 0.3);
  const std::vector<Vec3> near = {{0, 0, 0}, {0, 0.1, 0}, unknown_point()};
  EXPECT_EQ(*shoulder_within_reach(wanted, near, 0.5), wanted);
  const std::vector<Vec3> wide = {{0, 0, 0}, {0, 0.6, 0.2}, {0.2, 0.5, 0}};
  const auto moved = shoulder_within_reach(wanted, wide, 0.5);
  ASSERT_TRUE(moved.has_value());
  for (const Vec3& wrist : wide) EXPECT_LE((*moved - wrist).norm(), 0.5 + 1e-6);
  EXPECT_FALSE(shoulder_within_reach(wanted, {{0, 0, 0}, {0, 1.2, 0}}, 0.5).has_value());
}

TEST(ArmLengths, AreThePublishedShares) {
  const ArmLengths lengths = arm_lengths_of_stature(2.0);
  EXPECT_DOUBLE_EQ(lengths.upper_arm, 0.372);
  EXPECT_DOUBLE_EQ(lengths.forearm, 0.292);
}

}  // namespace
}  // namespace morphe::human
