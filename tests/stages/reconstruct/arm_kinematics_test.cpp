#include "stages/reconstruct/arm_kinematics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/stages/reconstruct/gloved_arm.hpp"

namespace morphe::reconstruct {
namespace {

/// The arm's joint centres at 100 Hz, with noise on each.
HumanMotion shaken(const GlovedArm& arm, double noise) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  HumanMotion motion;
  for (int i = 0; i < 500; ++i) {
    const human::ArmPose pose = arm.pose(0.01 * i);
    const auto near = [&](const Vec3& point) {
      return Vec3(point + noise * Vec3(normal(random), normal(random), normal(random)));
    };
    motion.time.push_back(0.01 * i);
    motion.shoulder.push_back(near(pose.shoulder));
    motion.elbow.push_back(near(pose.elbow));
    motion.wrist.push_back(near(pose.wrist));
    motion.wrist_orientation.push_back(pose.world_from_hand);
  }
  return motion;
}

double squares(const std::vector<Vec3>& points, const std::vector<Vec3>& others) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) sum += (points[i] - others[i]).squaredNorm();
  return sum;
}

TEST(KeepBoneLengths, MakesTheJointsMoreExactAndTheBonesConstant) {
  const GlovedArm arm;
  const HumanMotion truth = shaken(arm, 0), measured = shaken(arm, 0.002);
  HumanMotion kept = measured;
  enforce_bone_lengths(kept);
  for (std::size_t i = 0; i < kept.time.size(); ++i) {
    EXPECT_NEAR((kept.elbow[i] - kept.shoulder[i]).norm(), 0.30, 3e-4);
    EXPECT_NEAR((kept.elbow[i] - kept.shoulder[i]).norm(),
                (kept.elbow[0] - kept.shoulder[0]).norm(), 1e-12);
    EXPECT_NEAR((kept.wrist[i] - kept.elbow[i]).norm(), (kept.wrist[0] - kept.elbow[0]).norm(),
                1e-12);
  }
  EXPECT_LT(squares(kept.shoulder, truth.shoulder), squares(measured.shoulder, truth.shoulder));
  EXPECT_LT(squares(kept.elbow, truth.elbow), 0.9 * squares(measured.elbow, truth.elbow));
  EXPECT_LT(squares(kept.wrist, truth.wrist), squares(measured.wrist, truth.wrist));
  ASSERT_EQ(kept.residuals.size(), 2u);
  EXPECT_NEAR(kept.residuals[0].rms_m, 0.002 * std::sqrt(2), 0.0002);
}

TEST(KeepBoneLengths, LeavesWhatIsNotSeenAndWhatIsNoArm) {
  HumanMotion motion = shaken({}, 0.001);
  motion.shoulder[10] = motion.elbow[20] = motion.wrist[30] = unknown_point();
  const HumanMotion before = motion;
  enforce_bone_lengths(motion);
  EXPECT_FALSE(is_known(motion.shoulder[10]) || is_known(motion.elbow[20]) ||
               is_known(motion.wrist[30]));
  EXPECT_EQ(motion.wrist[20], before.wrist[20]);
  EXPECT_TRUE(is_known(motion.elbow[10]) && is_known(motion.elbow[30]));

  HumanMotion stretched = shaken({}, 0);
  for (std::size_t i = 0; i < stretched.time.size(); ++i) {
    stretched.wrist[i].y() += 0.1 * std::sin(0.1 * static_cast<double>(i));
  }
  const HumanMotion as_it_was = stretched;
  enforce_bone_lengths(stretched);
  EXPECT_EQ(squares(stretched.wrist, as_it_was.wrist), 0);
  EXPECT_THAT(stretched.reconstruction_notes,
              testing::ElementsAre(testing::HasSubstr("do not form an arm")));
}

TEST(AddArmAngles, FollowsTheArmAndLeavesWhatIsNotSeen) {
  const GlovedArm arm;
  HumanMotion motion = shaken(arm, 0);
  motion.elbow[7] = unknown_point();
  add_arm_angles(motion);
  ASSERT_EQ(motion.arm_angles.rows(), 500);
  for (Eigen::Index k = 0; k < 7; ++k) {
    EXPECT_NEAR(motion.arm_angles(123, k), arm.angles(1.23)[static_cast<std::size_t>(k)], 1e-9);
    EXPECT_TRUE(std::isnan(motion.arm_angles(7, k)));
  }
  EXPECT_LT(motion.residuals[0].max_m, 1e-9);
  HumanMotion nothing = shaken(arm, 0);
  for (Vec3& point : nothing.elbow) point = unknown_point();
  add_arm_angles(nothing);
  EXPECT_EQ(nothing.arm_angles.rows(), 0);
}

}  // namespace
}  // namespace morphe::reconstruct
