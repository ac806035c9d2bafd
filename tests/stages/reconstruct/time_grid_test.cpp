#include "stages/reconstruct/time_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morphe::reconstruct {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

TEST(OnClock, BridgesShortGapsAndLeavesLongOnes) {
  const ReconstructOptions options;
  std::vector<double> time, values;
  for (std::size_t i = 0; i < 400; ++i) {
    time.push_back(0.01 * static_cast<double>(i));
    values.push_back(std::sin(kTwoPi * 0.5 * time.back()));
  }
  const std::vector<double> truth = values;
  for (std::size_t i = 100; i < 109; ++i) values[i] = kUnknown;  // 0.1 s between neighbours
  for (std::size_t i = 250; i < 262; ++i) values[i] = kUnknown;
  const TimeGrid clock = make_time_grid({&time}, 100);
  ASSERT_EQ(clock.count, 400u);
  const auto result = resample(time, values, clock, options);
  for (std::size_t i = 0; i < 400; ++i) {
    if (i >= 250 && i < 262) {
      EXPECT_TRUE(std::isnan(result[i])) << i;
    } else {
      EXPECT_NEAR(result[i], truth[i], 2e-3) << i;
    }
  }
}

TEST(OnClock, BringsOtherRatesToTheClock) {
  const ReconstructOptions options;
  for (const double rate : {90.0, 240.0}) {
    std::vector<double> time, values;
    for (std::size_t i = 0; i < static_cast<std::size_t>(4 * rate); ++i) {
      time.push_back(0.5 + static_cast<double>(i) / rate);
      values.push_back(std::cos(kTwoPi * 0.7 * time.back()));
    }
    const TimeGrid clock = make_time_grid({&time}, options.rate_hz);
    EXPECT_DOUBLE_EQ(clock.at(0), 0.5);
    EXPECT_LE(clock.at(clock.count - 1), time.back() + 1e-9);
    EXPECT_GT(clock.at(clock.count), time.back());
    const auto result = resample(time, values, clock, options);
    for (int i = 30; i + 30 < clock.count; ++i) {
      EXPECT_NEAR(result[i], std::cos(kTwoPi * 0.7 * clock.at(i)), 1e-4);
    }
  }
}

/// The rate of a stream whose time stands still was infinite, and its remainder a division by zero.
TEST(OnClock, TimesThatStandStillRaceOrRunAway) {
  const ReconstructOptions options;
  const std::vector<double> values{1, 2, 3};
  for (const std::vector<double>& time :
       {std::vector<double>{1, 1, 1}, std::vector<double>{0, 1e-300, 2e-300},
        std::vector<double>{0, 1e-12, 2e-12}}) {
    const TimeGrid clock = make_time_grid({&time}, 100);
    EXPECT_EQ(clock.count, 1u);
    EXPECT_EQ(resample(time, values, clock, options).size(), 1u);
  }
  const std::vector<double> away{0, 1e300};
  EXPECT_EQ(make_time_grid({&away}, 100).count, 0u);
  EXPECT_TRUE(resample(away, {1, 2}, make_time_grid({&away}, 100), options).empty());
}

}  // namespace
}  // namespace morphe::reconstruct
