#include "core/motion/missing_goals.hpp"

#include <gtest/gtest.h>

namespace morphe {
namespace {

/// Two tips with goals every 0.1 s from 0 to 2 s: reach to 1 s with a preshape from 0.5 s on, grasp
/// to 1.5 s, hold to 2 s. A third tip is never seen, a fourth is closed automatically.
struct TwoTips {
  Goals goals;
  Movement movement;

  TwoTips() {
    goals.tip_position = Array2D<Vec3>(21, 4, Vec3::Zero());
    goals.auto_closed = {0, 0, 0, 1};
    for (std::size_t f = 0; f < 21; ++f) {
      goals.time.push_back(0.1 * static_cast<double>(f));
      goals.tip_position(f, 2) = goals.tip_position(f, 3) = unknown_point();
    }
    movement.end_s = 2;
    movement.phases = {{PhaseKind::reach, 0, 1.05},
                       {PhaseKind::preshape, 0.5, 1.05},
                       {PhaseKind::grasp, 1.05, 1.5},
                       {PhaseKind::hold, 1.5, 2}};
  }
  void hide(std::size_t tip, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f <= last; ++f) goals.tip_position(f, tip) = unknown_point();
  }
  MissingGoals missing() const { return missing_goals(goals, movement); }
};

TEST(MissingGoals, FingersThatWereNotRecordedAreNotMissing) {
  const MissingGoals missing = TwoTips().missing();
  EXPECT_EQ(missing.grasp_share, 0);
  EXPECT_EQ(missing.phase_share, 0);
  EXPECT_EQ(missing.gap_s, 0);
}

TEST(MissingGoals, AreCountedByPhaseWithPreshapeInReachAndHoldInGrasp) {
  TwoTips of;
  of.hide(0, 2, 8);    // 7 of the 22 goals of reach and preshape
  of.hide(1, 15, 18);  // 4 of the 20 goals of grasp and hold
  const MissingGoals missing = of.missing();
  EXPECT_DOUBLE_EQ(missing.grasp_share, 4.0 / 20);
  EXPECT_DOUBLE_EQ(missing.phase_share, 7.0 / 22);
  EXPECT_EQ(missing.phase, PhaseKind::reach);
  EXPECT_EQ(missing.gap_s, 0) << "the other tip has goals";
}

TEST(MissingGoals, TheLongestGapLiesBetweenTheGoalsAroundIt) {
  TwoTips of;
  for (const std::size_t tip : {0U, 1U}) {
    of.hide(tip, 3, 4);
    of.hide(tip, 10, 14);
  }
  const MissingGoals missing = of.missing();
  EXPECT_NEAR(missing.gap_s, 0.6, 1e-12);
  EXPECT_NEAR(missing.gap_begin_s, 0.9, 1e-12);
  EXPECT_NEAR(missing.gap_end_s, 1.5, 1e-12);
}

TEST(MissingGoals, AGapAtAnEndReachesToTheEnd) {
  TwoTips begin, end;
  for (const std::size_t tip : {0U, 1U}) {
    begin.hide(tip, 0, 3);
    end.hide(tip, 18, 20);
  }
  EXPECT_NEAR(begin.missing().gap_s, 0.4, 1e-12);
  EXPECT_NEAR(end.missing().gap_s, 0.3, 1e-12);
  EXPECT_NEAR(end.missing().gap_begin_s, 1.7, 1e-12);
}

TEST(MissingGoals, WithoutAnyGoalThereIsNoGap) {
  TwoTips of;
  for (const std::size_t tip : {0U, 1U}) of.hide(tip, 0, 20);
  EXPECT_EQ(of.missing().gap_s, 0) << "the reason is no_goal then";
  EXPECT_EQ(of.missing().phase_share, 0);
}

TEST(MissingGoals, AMovementWithoutPhasesIsOnePhase) {
  TwoTips of;
  of.movement.phases.clear();
  of.hide(0, 0, 13);
  EXPECT_DOUBLE_EQ(of.missing().phase_share, 14.0 / 42);
  EXPECT_EQ(of.missing().phase, PhaseKind::rest);
  EXPECT_EQ(of.missing().grasp_share, 0);
}

}  // namespace
}  // namespace morphe
