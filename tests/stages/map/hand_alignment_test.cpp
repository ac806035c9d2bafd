#include "stages/map/hand_alignment.hpp"

#include <gtest/gtest.h>

namespace morphe::map {
namespace {

/// Index, middle and ring along z, their knuckles side by side.
HandBones hand_of(double index, double middle, double ring, double gap, const Vec3& at) {
  HandBones bones;
  bones.length = {kUnknown, index, middle, ring, kUnknown};
  for (std::size_t f = 1; f <= 3; ++f) {
    bones.knuckle[f] = at + Vec3(0, gap * (2 - static_cast<double>(f)), 0);
  }
  return bones;
}

TEST(FitHand, NoFingerIsAskedToBeLongerThanItIs) {
  const HandBones human = hand_of(0.08, 0.1, 0.09, 0.02, {0, 0, 0.09});
  const HandBones robot = hand_of(0.13, 0.13, 0.13, 0.045, {0.02, 0.01, 0});
  const HandAlignment fit =
      align_hand(robot, human, {HandScale::finger_length, 1, HandAlignmentPoint::palm});
  EXPECT_NEAR(fit.scale, 0.13 / 0.1, 1e-12);
  EXPECT_EQ(fit.offset, Vec3::Zero());
  EXPECT_EQ(fit.problem, "");
}

TEST(FitHand, ByThePalmItIsAsBroadAsTheRobots) {
  const HandBones human = hand_of(0.08, 0.1, 0.09, 0.02, {0, 0, 0.09});
  const HandBones robot = hand_of(0.13, 0.13, 0.13, 0.045, {0.02, 0.01, 0});
  EXPECT_NEAR(
      align_hand(robot, human, {HandScale::palm_breadth, 1, HandAlignmentPoint::palm}).scale, 2.25,
      1e-12);
}

TEST(FitHand, AHandThatIsALargerOneMovedIsFittedExactly) {
  const HandBones human = hand_of(0.08, 0.1, 0.09, 0.02, {0, 0, 0.09});
  const Vec3 moved(0.01, -0.02, 0.3);
  const HandBones robot = hand_of(0.12, 0.15, 0.135, 0.03, 1.5 * Vec3(0, 0, 0.09) + moved);
  const HandAlignment fit =
      align_hand(robot, human, {HandScale::finger_length, 1, HandAlignmentPoint::knuckles});
  EXPECT_NEAR(fit.scale, 1.5, 1e-12);
  EXPECT_LT((fit.offset - moved).norm(), 1e-12);

  HumanMotion motion;
  motion.time = {0};
  motion.tip = motion.finger_joint = {1, kFingerCount, unknown_point()};
  motion.tip(0, 1) = Vec3(0.01, 0.02, 0.17);
  motion.tip(0, 2) = Vec3(0.01, 0, 0.19);
  const HumanMotion fitted = apply_alignment(motion, fit);
  EXPECT_LT((fitted.tip(0, 1) - (1.5 * motion.tip(0, 1) + moved)).norm(), 1e-12);
  const double distance = (fitted.tip(0, 1) - fitted.tip(0, 2)).norm() / fitted.hand_scale;
  EXPECT_NEAR(distance, (motion.tip(0, 1) - motion.tip(0, 2)).norm(), 1e-12);
  EXPECT_FALSE(is_known(fitted.tip(0, 0)));
}

TEST(FitHand, WhatIsNotKnownIsSaid) {
  const HandBones robot = hand_of(0.13, 0.13, 0.13, 0.045, Vec3::Zero());
  const HandAlignment unknown =
      align_hand(robot, {}, {HandScale::finger_length, 1, HandAlignmentPoint::knuckles});
  EXPECT_EQ(unknown.scale, 1);
  EXPECT_EQ(unknown.offset, Vec3::Zero());
  EXPECT_NE(unknown.problem, "");
  EXPECT_EQ(align_hand(robot, {}, {}).problem, "") << "nothing was asked for";
  EXPECT_NE(validation_error(HandOptions{HandScale::finger_length, 1.2, HandAlignmentPoint::palm}),
            "");
}

}  // namespace
}  // namespace morphe::map
