#include "stages/certify/approximate_reason.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morphe::certify {
namespace {

/// Ten frames of two tips, of which the second is never seen; the first `out` are out of reach.
Goals goals_with(std::size_t out) {
  Goals goals;
  goals.tip_position = Array2D<Vec3>(10, 2, unknown_point());
  goals.reachable = Array2D<std::uint8_t>(10, 2, 1);
  for (std::size_t f = 0; f < 10; ++f) {
    goals.time.push_back(0.01 * static_cast<double>(f));
    goals.tip_position(f, 0) = Vec3::Zero();
    goals.reachable(f, 0) = goals.reachable(f, 1) = f < out ? 0 : 1;
  }
  return goals;
}

Certificate off_by(double error_m) {
  Certificate certificate;
  certificate.tip_error_max = error_m;
  return certificate;
}

TEST(OnlyNear, ByTheShareOfSeenGoalsThatAreOutOfReach) {
  const Tolerances half;
  EXPECT_EQ(approximate_reason(goals_with(5), {}, half, off_by(0.004)), "");
  EXPECT_THAT(
      approximate_reason(goals_with(6), {}, half, off_by(0.004)),
      testing::StartsWith("approximate: 6 of 10 fingertip goals are out of reach (allowed: 50 %)"));
  Tolerances nearly_all;
  nearly_all.max_unreachable_share = 0.99;
  EXPECT_EQ(approximate_reason(goals_with(9), {}, nearly_all, off_by(0.004)), "");
  EXPECT_NE(approximate_reason(goals_with(10), {}, nearly_all, off_by(0.004)), "");
}

TEST(OnlyNear, ByTheFarthestTipWhateverTrackingAllows) {
  Tolerances wide;
  wide.tracking_tolerance = wide.tracking_tolerance_grasp = 10;
  EXPECT_EQ(approximate_reason(goals_with(0), {}, wide, off_by(0.05)), "");
  EXPECT_THAT(approximate_reason(goals_with(0), {}, wide, off_by(0.0512)),
              testing::HasSubstr("up to 51.2 mm from their goals (allowed: 50.0 mm)"));
  EXPECT_EQ(approximate_reason(goals_with(0), {}, wide, off_by(kUnknown)), "")
      << "no goal, no distance";
}

TEST(OnlyNear, ByTheLongestTimeWithoutAGoal) {
  Tolerances tolerances;
  tolerances.max_goal_gap_s = 0.035;
  Goals goals = goals_with(0);
  for (const std::size_t f : {4U, 5U}) goals.tip_position(f, 0) = unknown_point();
  EXPECT_EQ(approximate_reason(goals, {}, tolerances, off_by(0.004)), "") << "0.03 s";
  goals.tip_position(6, 0) = unknown_point();
  EXPECT_EQ(approximate_reason(goals, {}, tolerances, off_by(0.004)),
            "approximate: there is no fingertip goal for 0.04 s, 0.03–0.07 s (allowed: 0.04 s)");
}

TEST(OnlyNear, ByTheShareOfMissingGoalsInAPhase) {
  Goals goals = goals_with(0);
  for (const std::size_t f : {5U, 6U, 8U}) goals.tip_position(f, 0) = unknown_point();
  Movement movement;
  movement.phases = {{PhaseKind::reach, 0, 0.045}, {PhaseKind::grasp, 0.045, 0.09}};
  EXPECT_EQ(approximate_reason(goals, movement, {}, off_by(0.004)),
            "approximate: 60 % of the fingertip goals of phase grasp are missing (allowed: 50 %)");
  EXPECT_EQ(approximate_reason(goals, {}, {}, off_by(0.004)), "") << "three of ten in all";
}

}  // namespace
}  // namespace morphe::certify
