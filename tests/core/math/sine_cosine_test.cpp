#include "core/math/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace morphe::math {
namespace {

void expect_like_the_library(const std::vector<double>& angles, double tolerance) {
  std::vector<double> sine(angles.size()), cosine(angles.size());
  sine_cosine(angles.data(), angles.size(), sine.data(), cosine.data());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    ASSERT_NEAR(sine[i], std::sin(angles[i]), tolerance) << angles[i];
    ASSERT_NEAR(cosine[i], std::cos(angles[i]), tolerance) << angles[i];
  }
}

TEST(SineCosine, OfManyAnglesAreTheLibrarys) {
  std::mt19937 random(1);
  for (const double range : {1e-9, 1.0, 8.0, 1e3, 0.99e5}) {
    std::vector<double> angles(100003);
    for (double& angle : angles) {
      angle = std::uniform_real_distribution<>(-range, range)(random);
    }
    expect_like_the_library(angles, 5e-16);
  }
}

TEST(SineCosine, AtWholeQuarterTurns) {
  std::vector<double> angles;
  for (int k = -50; k <= 50; ++k) angles.push_back(k * (std::acos(-1.0) / 2));
  expect_like_the_library(angles, 3e-16);
  double sine = 7, cosine = 7;
  const double zero = 0;
  sine_cosine(&zero, 1, &sine, &cosine);
  EXPECT_EQ(sine, 0);
  EXPECT_EQ(cosine, 1);
}

TEST(SineCosine, BeyondItsRangeIsTheLibrarys) {
  expect_like_the_library({1e5, -3e7, 1e300, 0.5}, 3e-16);
  for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    double sine = 0, cosine = 0;
    sine_cosine(&odd, 1, &sine, &cosine);
    EXPECT_TRUE(std::isnan(sine));
    EXPECT_TRUE(std::isnan(cosine));
  }
}

}  // namespace
}  // namespace morphe::math
