#include "core/human/hand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/human/anthropometry.hpp"
#include "tests/support/expect_near.hpp"

namespace morphe::human {
namespace {

const HandSize kSize{0.200, 0.100};

/// Thumb rotation … little DIP [degrees]; the rest is zero.
HandPoints points_at(const std::vector<double>& degrees, double palm_arch = 0) {
  HandAngles angles;
  for (std::size_t k = 0; k < degrees.size(); ++k) angles.joint[k] = degrees[k] * kRadPerDegree;
  angles.palm_arch = palm_arch * kRadPerDegree;
  std::vector<Pose> frames;
  return hand_points(human_hand(kSize), angles, frames);
}

TEST(HumanHand, FlatFingersLieAsBuchholzMeasured) {
  const HandPoints flat = points_at({});
  expect_near(flat.tip[1], Vec3(0, 0.0251, (0.447 + 0.245 + 0.143 + 0.097) * 0.2));
  expect_near(flat.middle_joint[1], Vec3(0, 0.0251, (0.447 + 0.245) * 0.2));
  const double middle = (0.266 + 0.170 + 0.108) * 0.2;
  expect_near(flat.tip[2], Vec3(0, -middle * std::sin(3 * kRadPerDegree),
                                0.446 * 0.2 + middle * std::cos(3 * kRadPerDegree)));
  const double little = (0.204 + 0.117 + 0.093) * 0.2;
  expect_near(flat.tip[4], Vec3(0, -0.0402 - little * std::sin(8 * kRadPerDegree),
                                0.368 * 0.2 + little * std::cos(8 * kRadPerDegree)));
  EXPECT_NEAR(flat.tip[2].norm(), kSize.length, 0.02 * kSize.length);
  const double thumb = (0.251 + 0.196 + 0.158) * 0.2;
  expect_near(flat.tip[0], Vec3(0, 0.0196 + thumb / 2, 0.073 * 0.2 + thumb * std::sqrt(0.75)));
  for (std::size_t finger = 1; finger < kFingerCount; ++finger) {
    expect_near(flat.tip_orientation[finger] * Vec3::UnitX(), Vec3::UnitX());
  }
  expect_near(flat.tip_orientation[1] * Vec3::UnitZ(), Vec3::UnitZ());
  expect_near(flat.tip_orientation[0] * Vec3::UnitZ(), Vec3(0, 0.5, std::sqrt(0.75)));
}

TEST(HumanHand, FlexionCurlsToThePalmAndAbductionGoesToTheThumb) {
  const HandPoints hooked = points_at({0, 0, 0, 0, 0, 0, 90});  // index PIP
  expect_near(hooked.tip[1], Vec3((0.143 + 0.097) * 0.2, 0.0251, (0.447 + 0.245) * 0.2));
  expect_near(hooked.tip_orientation[1] * Vec3::UnitX(), -Vec3::UnitZ());
  const HandPoints bent = points_at({0, 0, 0, 0, 0, 50, 40, 90});
  const double p = 0.245 * 0.2, m = 0.143 * 0.2, d = 0.097 * 0.2;
  expect_near(bent.tip[1], Vec3(p * std::sin(50 * kRadPerDegree) + m, 0.0251,
                                0.447 * 0.2 + p * std::cos(50 * kRadPerDegree) - d));
  const HandPoints spread = points_at({0, 0, 0, 0, 30});
  const double length = p + m + d;
  expect_near(spread.tip[1], Vec3(0, 0.0251 + length * std::sin(30 * kRadPerDegree),
                                  0.447 * 0.2 + length * std::cos(30 * kRadPerDegree)));
}

TEST(HumanHand, PalmArchLowersLittleAndRingFinger) {
  const HandPoints flat = points_at({}), arched = points_at({}, 28);
  expect_near(arched.tip[1], flat.tip[1]);
  expect_near(arched.tip[2], flat.tip[2]);
  EXPECT_NEAR(arched.tip[4].x(), flat.tip[4].z() * std::sin(28 * kRadPerDegree), 1e-12);
  EXPECT_NEAR(arched.tip[3].x(), flat.tip[3].z() * std::sin(20 * kRadPerDegree), 1e-12);
}

TEST(HumanHand, TheThumbSwingsOutOfThePalmAndMeetsTheIndex) {
  const double thumb = (0.251 + 0.196 + 0.158) * 0.2;
  const HandPoints opposed = points_at({90});
  expect_near(opposed.tip[0], Vec3(thumb / 2, 0.0196, 0.073 * 0.2 + thumb * std::sqrt(0.75)));
  // Its pad then looks back at the palm, from in front of it.
  EXPECT_LT((opposed.tip_orientation[0] * Vec3::UnitX()).x(), -0.8);
  // At zero rotation its joints bend it across the palm.
  const HandPoints across = points_at({0, 0, 50, 50});
  EXPECT_NEAR(across.tip[0].x(), 0, 1e-12);
  EXPECT_LT(across.tip[0].y(), points_at({}).tip[0].y() - 0.04);

  const std::vector<double> pinch = {85, 22, 1, 3, 0, 73, 26, 15};
  const RobotModel hand = human_hand(kSize);
  for (std::size_t k = 0; k < pinch.size(); ++k) {
    const auto joint = static_cast<Eigen::Index>(k);
    EXPECT_GE(pinch[k] * kRadPerDegree, hand.lower[joint]);
    EXPECT_LE(pinch[k] * kRadPerDegree, hand.upper[joint]);
  }
  const HandPoints closed = points_at(pinch);
  EXPECT_LT((closed.tip[0] - closed.tip[1]).norm(), 0.01);
  EXPECT_GT((points_at({}).tip[0] - points_at({}).tip[1]).norm(), 0.06);
  EXPECT_LT(
      (closed.tip_orientation[0] * Vec3::UnitX()).dot(closed.tip_orientation[1] * Vec3::UnitX()),
      -0.3);
}

TEST(HumanHand, IsAWholeRobotTable) {
  const RobotModel hand = human_hand(kSize);
  ASSERT_EQ(hand.joints(), kHandAngleCount + 1);
  for (std::size_t k = 0; k < kHandAngleCount; ++k)
    EXPECT_EQ(hand.joint_names[k], kHandAngleNames[k]);
  EXPECT_EQ(hand.joint_names.back(), "palm_arch");
  EXPECT_TRUE((hand.lower.array() <= 0).all());
  EXPECT_TRUE((hand.upper.array() > 0).all());
  EXPECT_NEAR(hand.upper[6], 100 * kRadPerDegree, 1e-12);  // index PIP
  EXPECT_NEAR(hand.lower[16], -33 * kRadPerDegree,
              1e-12);  // the little finger spreads from the thumb
  for (std::size_t i = 0; i < hand.frames.size(); ++i) {
    EXPECT_LT(hand.frames[i].parent, static_cast<int>(i));
  }
}

TEST(Anthropometry, IsAnsur) {
  const Anthropometry woman = anthropometry(Sex::female, {});
  EXPECT_DOUBLE_EQ(woman.stature_m, 1.629);
  EXPECT_DOUBLE_EQ(woman.hand.breadth, 0.078);
  const Anthropometry man = anthropometry(Sex::male, {1, -1, 2, 0.5, -0.5});
  EXPECT_NEAR(man.stature_m, 1.825, 1e-12);
  EXPECT_NEAR(man.arm.upper_arm, 0.317, 1e-12);
  EXPECT_NEAR(man.arm.forearm, 0.298, 1e-12);
  EXPECT_NEAR(man.hand.length, 0.198, 1e-12);
  EXPECT_NEAR(man.hand.breadth, 0.086, 1e-12);
  // The mean adult's hand from stature alone, against the means of both.
  const HandSize hand = hand_size_of_stature((1.756 + 1.629) / 2);
  EXPECT_NEAR(hand.length, (0.193 + 0.181) / 2, 0.001);
  EXPECT_NEAR(hand.breadth, (0.088 + 0.078) / 2, 0.001);
}

}  // namespace
}  // namespace morphe::human
