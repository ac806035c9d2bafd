#include "stages/import/trackers/time_unit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

/// The times of five rows with a period, with one row lost.
std::vector<double> times(double period) {
  return {10 * period, 11 * period, 12 * period, 14 * period, 15 * period};
}

double seconds(const std::vector<double>& time, const std::string& unit = "") {
  std::vector<std::string> reports;
  return seconds_per_unit("t", unit, time, "a.csv", reports);
}

TEST(TimeUnit, IsThatOfTheRateOfACamera) {
  for (const double rate_hz : {1.5, 10.0, 25.0, 29.97, 100.0, 240.0, 999.0}) {
    EXPECT_EQ(seconds(times(1 / rate_hz)), 1) << rate_hz;
    EXPECT_EQ(seconds(times(1e3 / rate_hz)), 1e-3) << rate_hz;
    EXPECT_EQ(seconds(times(1e6 / rate_hz)), 1e-6) << rate_hz;
    EXPECT_EQ(seconds(times(1e9 / rate_hz)), 1e-9) << rate_hz;
  }
}

TEST(TimeUnit, OfTheHeaderIsBelieved) {
  EXPECT_EQ(seconds(times(40), "s"), 1);
  EXPECT_EQ(seconds(times(0.04), "ms"), 1e-3);
  EXPECT_EQ(seconds(times(1), "ms"), 1e-3);
}

TEST(TimeUnit, NumbersOfFramesAreNoTimes) {
  try {
    seconds(times(1));
    ADD_FAILURE() << "not asked";
  } catch (const UnresolvedConvention& asked) {
    EXPECT_EQ(asked.key, "rate");
    EXPECT_THAT(asked.what(), testing::StartsWith("a.csv: rate: 't' has whole numbers"));
  }
}

TEST(TimeUnit, OneTimeHasNone) { EXPECT_EQ(seconds({5}), 1); }

}  // namespace
}  // namespace morphe::imports
