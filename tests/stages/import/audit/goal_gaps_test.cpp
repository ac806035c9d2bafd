#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// Goals of two tips every 10 ms: a reach to 1 s, then a grasp to 2 s.
struct ReachToGrasp {
  Demonstration recording;
  HumanMotion motion;
  Movement movement;
  Goals goals;

  ReachToGrasp() {
    goals.tip_position = Array2D<Vec3>(201, 2, Vec3::Zero());
    for (std::size_t f = 0; f < 201; ++f) goals.time.push_back(0.01 * static_cast<double>(f));
    movement.end_s = 2;
    movement.phases = {{PhaseKind::reach, 0, 1}, {PhaseKind::grasp, 1, 2}};
  }
  void hide(std::size_t tip, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f <= last; ++f) goals.tip_position(f, tip) = unknown_point();
  }
  std::vector<RecordingFlag> flags(const AuditOptions& options = {}) const {
    return check_goals({recording, motion, movement, goals}, options);
  }
};

TEST(GoalGaps, ATwentiethOfTheGraspMayBeMissing) {
  ReachToGrasp of;
  of.hide(0, 120, 129);
  EXPECT_TRUE(of.flags().empty());
}

TEST(GoalGaps, MoreThanAFifthOfTheGraspIsFlaggedWithItsShare) {
  ReachToGrasp of;
  of.hide(0, 120, 169);  // 50 of 202 goals
  const auto flags = of.flags();
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].code, FlagCode::missing_goals);
  EXPECT_NEAR(flags[0].value, 50.0 / 202, 1e-9);
  EXPECT_EQ(flags[0].limit, 0.2);
  EXPECT_THAT(flags[0].text, testing::StartsWith("25 % of the fingertip goals in grasp and hold"));
  AuditOptions lenient;
  lenient.max_missing_goal_share = 0.3;
  EXPECT_TRUE(of.flags(lenient).empty());
  EXPECT_NE(refused_flag(flags, {}), nullptr) << "by default";
}

TEST(GoalGaps, TheReachMayLackATipButNotBothForLong) {
  ReachToGrasp of;
  of.hide(0, 0, 90);
  EXPECT_TRUE(of.flags().empty());
  of.hide(1, 5, 32);
  EXPECT_TRUE(of.flags().empty()) << "0.29 s between the goals around the gap";
  of.hide(1, 5, 80);
  const auto flags = of.flags();
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_NEAR(flags[0].value, 0.77, 1e-9);
  EXPECT_EQ(flags[0].unit, "s");
  EXPECT_NEAR(flags[0].begin_s, 0.04, 1e-9);
  EXPECT_NEAR(flags[0].end_s, 0.81, 1e-9);
  AuditOptions lenient;
  lenient.max_goal_gap_s = 0.8;
  EXPECT_TRUE(of.flags(lenient).empty());
}

TEST(GoalGaps, NoGoalAtAllIsAnotherMatter) {
  ReachToGrasp of;
  for (const std::size_t tip : {0U, 1U}) of.hide(tip, 0, 200);
  EXPECT_TRUE(of.flags().empty()) << "no_goal";
}

}  // namespace
}  // namespace morphe::imports
