// The limits of a Franka Research 3 (libfranka, rate_limiting.h: 12 rad/s², 0.3 rad/s, ends at
// 2.7501 rad for the first joint), against dense sampling and closed forms.
#include "core/math/braking.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::math {
namespace {

const RobotModel::BrakingCurve kCurve = {0, 12, 0.3, -2.7501, 2.7501};

TEST(Braking, SpeedLeftIsTheRobotsOwnFormula) {
  EXPECT_NEAR(braking_speed_limit(kCurve, 2.7501 - 0.1, true), std::sqrt(1.2) - 0.3, 1e-14);
  EXPECT_NEAR(braking_speed_limit(kCurve, -2.7501 + 0.1, false), std::sqrt(1.2) - 0.3, 1e-14);
  EXPECT_EQ(braking_speed_limit(kCurve, 2.7501 - 0.3 * 0.3 / 12 + 1e-12, true), 0);
  EXPECT_EQ(braking_speed_limit(kCurve, 3, true), 0);
  EXPECT_GT(braking_speed_limit(kCurve, 3, false), 2.62);
}

TEST(Braking, RatioIsThatOfDenseSamples) {
  const double ends[][2] = {{2.0, 2.6}, {-2.6, -1.9}, {2.55, 2.0}, {0, 2.7}};
  for (const auto& [from, to] : ends) {
    for (const double v0 : {-0.4, 0.0, 0.5}) {
      const QuinticPiece piece = quintic_piece({from, v0, 0.2}, {to, 0, 0}, 1.5);
      double sampled = 0;
      for (int k = 0; k <= 200000; ++k) {
        const double t = 1.5 * k / 200000, v = value_at(piece, t, 1);
        const double left = braking_speed_limit(kCurve, value_at(piece, t), v > 0);
        sampled = std::max(sampled, std::abs(v) / left);
      }
      const double found = braking_ratio(kCurve, piece);
      EXPECT_GE(found, sampled * (1 - 1e-6));
      EXPECT_LT(found, sampled * (1 + 2e-6));
      EXPECT_EQ(braking_ratio(kCurve, piece, 1e9), 1e9);
    }
  }
}

TEST(Braking, MovingWhereNothingIsLeftIsBeyondEveryLimit) {
  const QuinticPiece piece = quintic_piece({2.7, 0.01, 0}, {2.76, 0.01, 0}, 1);
  EXPECT_TRUE(std::isinf(braking_ratio(kCurve, piece)));
  const QuinticPiece still = quintic_piece({2.75, 0, 0}, {2.75, 0, 0}, 1);
  EXPECT_EQ(braking_ratio(kCurve, still), 0);
}

}  // namespace
}  // namespace morphe::math
