#include "core/humanlike/metrics.hpp"

#include <gtest/gtest.h>

namespace morphe::humanlike {
namespace {

TEST(Metrics, JointDistanceIsTheSumOfSquares) {
  EXPECT_DOUBLE_EQ(joint_distance_sum({0, 0, 0}, {{1, 0, 0}, {0, 2, 0}}), 5);
}

TEST(Metrics, TriangleAreasVanishWhenTheChainsCoincide) {
  const Chain chain{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0, -0.25}};
  EXPECT_NEAR(triangle_area_sum(chain, chain), 0, 1e-12);
}

TEST(Metrics, TriangleAreaOfTwoStraightChainsAtAnAngle) {
  // Both of length 2 with a knot in the middle, at right angles: one inner human joint (1,0,0), the
  // corresponding robot joint (0,1,0), the next one (0,2,0): area 1/2 * base 1 * height 1.
  const Chain human{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Chain robot{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  EXPECT_NEAR(triangle_area_sum(human, robot), 0.5, 1e-12);
}

TEST(Metrics, VirtualJointsStandAtTheUnionOfTheKnots) {
  // Human knots 0, 1/2, 1; robot knots 0, 1/4, 1, straight along y: inner knots 1/4 and 1/2.
  const Chain human{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Chain robot{{0, 0, 0}, {0, 0.5, 0}, {0, 2, 0}};
  // (0.5,0,0)-(0,0.5,0)-(0,1,0): 1/2 * 0.5 * 0.5; (1,0,0)-(0,1,0)-(0,2,0): 1/2 * 1 * 1
  EXPECT_NEAR(triangle_area_sum(human, robot), 0.125 + 0.5, 1e-12);
}

TEST(Metrics, HullSumSplitsTheRobotAtTheElbow) {
  const Chain human{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  // Four links of equal length: knots 1/4, 1/2 belong to the upper set, 3/4 and 1 to the lower.
  const Chain robot{{0, 0, 0}, {0, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 1, 0.5}};
  // (0,0,0) (1,0,0) (0,0.5,0) (0,0.5,0.5) and (1,0,0) (2,0,0) (0.5,0.5,0.5) (0.5,1,0.5), each 1/24.
  EXPECT_NEAR(hull_volume_sum(human, robot), 2.0 / 24, 1e-15);
}

}  // namespace
}  // namespace morphe::humanlike
