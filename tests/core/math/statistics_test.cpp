#include "core/math/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::math {
namespace {

const std::vector<double> kFive = {7, 1, 9, 3, 5}, kFour = {10, 40, 20, 30};

TEST(Statistics, QuantileTakesTheNearestRank) {
  EXPECT_EQ(quantile(kFive, 0), 1);
  EXPECT_EQ(quantile(kFive, 0.2), 1);
  EXPECT_EQ(quantile(kFive, 0.21), 3);
  EXPECT_EQ(quantile(kFour, 0.5), 20);
  EXPECT_EQ(quantile(kFour, 1), 40);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, LowerQuantileRoundsTheRankDown) {
  EXPECT_EQ(lower_quantile(kFive, 0), 1);
  EXPECT_EQ(lower_quantile(kFive, 0.24), 1);
  EXPECT_EQ(lower_quantile(kFive, 0.25), 3);
  EXPECT_EQ(lower_quantile(kFour, 0.5), 20);
  EXPECT_EQ(lower_quantile(kFour, 0.99), 30);
  EXPECT_EQ(lower_quantile(kFour, 1), 40);
  EXPECT_TRUE(std::isnan(lower_quantile({}, 0.5)));
}

TEST(Statistics, MedianOfAnEvenNumberIsTheUpperOneOrTheMean) {
  EXPECT_EQ(median(kFive), 5);
  EXPECT_EQ(median(kFour), 30);
  EXPECT_EQ(median({8}), 8);
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_EQ(midpoint_median(kFive), 5);
  EXPECT_EQ(midpoint_median(kFour), 25);
  EXPECT_EQ(midpoint_median({8}), 8);
  EXPECT_TRUE(std::isnan(midpoint_median({})));
}

TEST(Statistics, MedianPointTakesEachCoordinateOfTheKnownPoints) {
  const std::vector<Vec3> points = {
      {1, 30, 5}, unknown_point(), {2, 10, 7}, {100, kUnknown, 100}, {3, 20, 6}};
  EXPECT_EQ(median_point(points), Vec3(2, 20, 6));
  EXPECT_FALSE(is_known(median_point({unknown_point()})));
  EXPECT_FALSE(is_known(median_point({})));
}

TEST(Statistics, MedianDistanceLeavesOutFramesInWhichOneIsUnknown) {
  const std::vector<Vec3> from = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {2, 0, 0}},
                          to = {{3, 4, 0}, {1, 1, 2}, unknown_point(), {2, 2, 0}};
  EXPECT_EQ(median_distance(from, to), 2);
  EXPECT_TRUE(std::isnan(median_distance({unknown_point()}, {Vec3::Zero()})));
  EXPECT_TRUE(std::isnan(median_distance({}, {})));
}

TEST(Statistics, MeanLeavesOutWhatIsNotANumber) {
  EXPECT_EQ(mean({1, kUnknown, 2, 6}), 3);
  EXPECT_TRUE(std::isnan(mean({kUnknown})));
}

TEST(Statistics, CorrelationInClosedForm) {
  // The correlation of 0, 1, 2, 3 and their squares is 15 / sqrt(5 · 49).
  EXPECT_NEAR(correlation({0, 1, 2, 3}, {0, 1, 4, 9}), 15 / std::sqrt(245.0), 1e-15);
  EXPECT_NEAR(correlation({1, 2, 4}, {-2, -4, -8}), -1, 1e-15);
  EXPECT_TRUE(std::isnan(correlation({1}, {2})));
  EXPECT_TRUE(std::isnan(correlation({1, 1, 1}, {1, 2, 3})));
}

}  // namespace
}  // namespace morphe::math
