#include "stages/map/finger_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::map {
namespace {

const std::array<Vec3, 4> kTips = {
    {{0.01, 0.04, 0.18}, {0.0, 0.015, 0.19}, {-0.005, -0.01, 0.185}, {0.0, -0.035, 0.16}}};

TEST(FingerCurve, OfALineIsTheLine) {
  const Vec3 from(0.1, 0.2, 0.3), way(0.05, -0.02, 0.01);
  const std::array<Vec3, 4> tips = {from, from + 0.2 * way, from + 0.5 * way, from + way};
  for (const double share : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    EXPECT_LT((finger_curve_point(tips, share) - from - share * way).norm(), 1e-9);
  }
}

TEST(FingerCurve, EndsAreIncludedAndStepsAreEqual) {
  EXPECT_LT((finger_curve_point(kTips, 0) - kTips[0]).norm(), 1e-9);
  EXPECT_LT((finger_curve_point(kTips, 1) - kTips[3]).norm(), 1e-9);
  constexpr int kSteps = 2000;
  double least = 1, most = 0;
  std::array<double, 4> nearest = {1, 1, 1, 1};
  Vec3 before = kTips[0];
  for (int k = 1; k <= kSteps; ++k) {
    const Vec3 here = finger_curve_point(kTips, static_cast<double>(k) / kSteps);
    least = std::min(least, (here - before).norm());
    most = std::max(most, (here - before).norm());
    for (std::size_t i = 0; i < 4; ++i) {
      nearest[i] = std::min(nearest[i], (here - kTips[i]).norm());
    }
    before = here;
  }
  EXPECT_LT((most - least) / most, 1e-4);  // chords of equal arcs
  for (const double distance : nearest) EXPECT_LT(distance, most);
}

/// Four points at equal angles of a circle: a spline between them stays near it, and the middle of
/// the curve lies on its axis of symmetry.
TEST(FingerCurve, OfACircleIsSymmetric) {
  constexpr double kRadius = 0.08;
  std::array<Vec3, 4> tips;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = 0.3 * (static_cast<double>(i) - 1.5);
    tips[i] = kRadius * Vec3(std::sin(angle), 0, std::cos(angle));
  }
  const Vec3 middle = finger_curve_point(tips, 0.5);
  EXPECT_NEAR(middle.x(), 0, 1e-9);
  EXPECT_NEAR(middle.z(), kRadius, 2e-4);
  const Vec3 third = finger_curve_point(tips, 0.25), mirrored = finger_curve_point(tips, 0.75);
  EXPECT_NEAR(third.x(), -mirrored.x(), 1e-9);
  EXPECT_NEAR(third.z(), mirrored.z(), 1e-9);
}

TEST(FingerCurve, NeedsAllFour) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Vec3, 4> tips = kTips;
    tips[i] = unknown_point();
    EXPECT_FALSE(is_known(finger_curve_point(tips, 0.5)));
  }
}

}  // namespace
}  // namespace morphe::map
