#include <gtest/gtest.h>

#include <limits>

#include "pipeline/study/retime_paths.hpp"
#include "pipeline/study/retime_reference.hpp"
#include "pipeline/study/score_timing.hpp"
#include "stages/retime/retime.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::study {
namespace {

TEST(RetimeStudy, RandomPathsHoldTheirLimits) {
  for (std::uint64_t index = 0; index < 10; ++index) {
    const RandomPath random = random_path(7, index);
    if (random.path.position.size() > 4000) continue;  // the study has them all
    for (const retime::RetimeMode mode : {retime::RetimeMode::human, retime::RetimeMode::fastest}) {
      retime::RetimeOptions options;
      options.mode = mode;
      const Outcome<retime::RetimeResult> result =
          retime::retime(random.robot, random.path, Movement{}, options);
      ASSERT_EQ(result.failure.reason, Reason::none)
          << index << " " << name_of(mode) << ": " << result.failure.detail;
      const LimitUsage seen = measure_limit_usage(random.robot, result.value.trajectory);
      EXPECT_LE(seen.velocity, 1.001) << index;
      EXPECT_LE(seen.acceleration, 1.001) << index;
      EXPECT_LE(seen.jerk, 1.01) << index;
      EXPECT_LE(seen.position_excess, 0) << index;
      EXPECT_TRUE(seen.at_rest && seen.time_increases) << index;
    }
  }
}

/// They left their range: 6442 and 7715 between samples that were too far apart for their quintics,
/// 4998 and 15713 because the path itself did between two knots, after its end was met.
TEST(RetimeStudy, PathsThatTouchTheirRangeStayInside) {
  for (const std::uint64_t index : {4998u, 6442u, 7715u, 15713u}) {
    const RandomPath random = short_path(1, index);
    retime::RetimeOptions options;
    options.sample_rate_hz = random.sample_rate_hz;
    const Outcome<retime::RetimeResult> result =
        retime::retime(random.robot, random.path, Movement{}, options);
    ASSERT_EQ(result.failure.reason, Reason::none) << index << ": " << result.failure.detail;
    EXPECT_LE(measure_limit_usage(random.robot, result.value.trajectory).position_excess, 0)
        << index;
  }
}

/// Its law stood still for so long that the samples took all memory.
TEST(RetimeStudy, NoPathTakesLongerThanAnHour) {
  const RandomPath random = short_path(3, 10613);
  for (const retime::RetimeMode mode : {retime::RetimeMode::human, retime::RetimeMode::fastest}) {
    retime::RetimeOptions options;
    options.mode = mode;
    options.sample_rate_hz = random.sample_rate_hz;
    const Outcome<retime::RetimeResult> result =
        retime::retime(random.robot, random.path, Movement{}, options);
    if (result.failure) {
      EXPECT_EQ(result.failure.reason, Reason::joint_limit);
    } else {
      EXPECT_LE(result.value.trajectory.time.back(), 3600);
    }
  }
}

TEST(RetimeStudy, WithinHalfAPercentOfTheLeastTime) {
  for (std::uint64_t index = 0; index < 3; ++index) {
    const RandomPath random = smooth_path(3, index, 1 + 4 * static_cast<int>(index), 100, 1.5);
    const Movement movement;
    const retime::ConstrainedPath paced_path =
        paced_path_without_jerk(random.robot, random.path, movement);
    const double ratio =
        retime::fastest_law(paced_path).duration_s / reference_least_time_s(paced_path, 20000);
    EXPECT_GE(ratio, 0.995) << index;
    EXPECT_LE(ratio, 1.005) << index;
  }
}

TEST(RetimeStudy, SeenLimitsOfAKnownQuintic) {
  // p = t^3 over one second: v = 3 t^2, a = 6 t, j = 6.
  RobotModel robot;
  robot.lower = JointVector::Constant(1, 0);
  robot.upper = JointVector::Constant(1, 0.9);
  robot.velocity = JointVector::Constant(1, 3);
  robot.acceleration = JointVector::Constant(1, 12);
  robot.jerk = JointVector::Constant(1, 24);
  Trajectory t;
  t.time = {0, 1};
  t.position = t.velocity = t.acceleration = JointRows::Zero(2, 1);
  t.position(1, 0) = 1;
  t.velocity(1, 0) = 3;
  t.acceleration(1, 0) = 6;
  const LimitUsage seen = measure_limit_usage(robot, t);
  EXPECT_NEAR(seen.velocity, 1, 1e-12);
  EXPECT_NEAR(seen.acceleration, 0.5, 1e-12);
  EXPECT_NEAR(seen.jerk, 0.25, 1e-12);
  EXPECT_NEAR(seen.position_excess, 0.1, 1e-12);
  EXPECT_FALSE(seen.at_rest);
  EXPECT_TRUE(seen.time_increases);
}

}  // namespace
}  // namespace morphe::study
