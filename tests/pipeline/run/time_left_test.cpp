#include "pipeline/run/time_left.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/run/progress.hpp"

namespace morphe::run {
namespace {

TEST(TimeLeft, IsUnknownBeforeOneIsFinished) {
  const RunWorkload work{0, 0, {3, 4}, 10, 2};
  EXPECT_TRUE(std::isnan(seconds_per_demonstration(work)));
  EXPECT_TRUE(std::isnan(time_left_s(work)));
  EXPECT_EQ(progress_text({}, 12, work), "0 of 12: 0 executable (0 repaired), 0 infeasible");
}

TEST(TimeLeft, FourThreadsAfterTheFirstOfTwelveEqualOnes) {
  // All four began together and take 10 s each: 8 wait, three are about to end, 20 s are left.
  const RunWorkload work{10, 1, {10, 10, 10}, 8, 4};
  EXPECT_DOUBLE_EQ(time_left_s(work), 20);
}

TEST(TimeLeft, OneThreadCountsDownInsideADemonstration) {
  for (const double age_s : {0.0, 2.5, 9.0})
    EXPECT_DOUBLE_EQ(time_left_s({30, 3, {age_s}, 2, 1}), 30 - age_s);
}

TEST(TimeLeft, OneThatTakesLongerCounts) {
  EXPECT_DOUBLE_EQ(seconds_per_demonstration({10, 1, {30}, 0, 1}), 20);
  EXPECT_DOUBLE_EQ(time_left_s({10, 1, {30}, 5, 1}), 5 * 20);
}

TEST(TimeLeft, TheLastOnesAreNotShared) {
  EXPECT_DOUBLE_EQ(time_left_s({10, 1, {4}, 0, 8}), 6) << "seven threads have nothing to do";
}

TEST(TimeLeft, IsSaidWithItsRate) {
  BatchSummary sum;
  sum.demonstrations = 3;
  sum.executable = 4;
  sum.failed = 1;
  EXPECT_EQ(progress_text(sum, 5, {30, 3, {0}, 1, 1}),
            "3 of 5, 6.0 per minute, 20 s left: 4 executable (0 repaired), 0 infeasible, 1 failed");
}

TEST(TimeLeft, NumbersAndWhatTheyCount) {
  EXPECT_EQ(count_with_noun(1, "demonstration"), "1 demonstration");
  EXPECT_EQ(count_with_noun(0, "demonstration"), "0 demonstrations");
  EXPECT_EQ(count_with_noun(std::size_t{2}, "joint is", "joints are"), "2 joints are");
}

}  // namespace
}  // namespace morphe::run
