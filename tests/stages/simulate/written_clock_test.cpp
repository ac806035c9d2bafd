#include "stages/simulate/written_clock.hpp"

#include <gtest/gtest.h>

#include "stages/simulate/options.hpp"

namespace morphe::simulate {
namespace {

TEST(Clock, RunsAtItsRateWithoutRamps) {
  const WrittenClock clock(0.5, 2, false, false);
  EXPECT_DOUBLE_EQ(clock.duration_s(), 1.5);
  EXPECT_DOUBLE_EQ(clock.at(0.3).time_s, 0.8);
  EXPECT_EQ(clock.at(0.3).rate, 1);
}

TEST(Clock, StartsAndStopsSmoothlyAndComesToItsEnd) {
  for (const double length : {2.0, 0.3, 0.05}) {  // long, with ramps alone, with short ramps
    const WrittenClock clock(1, 1 + length, true, true);
    EXPECT_NEAR(clock.duration_s(), length + std::min(kClockRamp_s, length), 1e-12);
    const double end = clock.duration_s(), h = 1e-6;
    EXPECT_NEAR(clock.at(0).time_s, 1, 1e-12);
    EXPECT_NEAR(clock.at(end).time_s, 1 + length, 1e-12);
    EXPECT_NEAR(clock.at(0).rate, 0, 1e-12);
    EXPECT_NEAR(clock.at(end).rate, 0, 1e-12);
    for (const double share : {0.07, 0.2, 0.5, 0.8, 0.96}) {
      const double t = share * end;
      EXPECT_NEAR((clock.at(t + h).time_s - clock.at(t - h).time_s) / (2 * h), clock.at(t).rate,
                  1e-6);
      EXPECT_NEAR((clock.at(t + h).rate - clock.at(t - h).rate) / (2 * h), clock.at(t).rate_slope,
                  1e-3);
    }
  }
}

TEST(Clock, OfAnEmptyIntervalStays) {
  const WrittenClock clock(1, 1, true, true);
  EXPECT_EQ(clock.duration_s(), 0);
}

}  // namespace
}  // namespace morphe::simulate
