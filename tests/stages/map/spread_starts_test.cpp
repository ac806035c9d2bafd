#include <gtest/gtest.h>

#include <set>

#include "stages/map/mapping_problem.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::map {
namespace {

/// Every joint has one start in each of the equal parts of its range.
TEST(SpreadStarts, AreALatinHypercube) {
  const RobotModel robot = robot::shipped_robot("pa10_dlr_hit2");
  constexpr int kCount = 24;
  const std::vector<JointVector> starts = spread_starts(robot, kCount, 7);
  ASSERT_EQ(starts.size(), kCount);
  for (Eigen::Index j = 0; j < robot.lower.size(); ++j) {
    std::set<int> parts;
    for (const JointVector& q : starts) {
      const double share = (q[j] - robot.lower[j]) / (robot.upper[j] - robot.lower[j]);
      parts.insert(static_cast<int>(share * kCount));
      EXPECT_NEAR(share * kCount - std::floor(share * kCount), 0.5, 1e-9);
    }
    EXPECT_EQ(parts.size(), kCount);
  }
}

TEST(SpreadStarts, DependOnTheSeedAlone) {
  const RobotModel robot = robot::shipped_robot("pa10_dlr_hit2");
  EXPECT_EQ(spread_starts(robot, 5, 7), spread_starts(robot, 5, 7));
  EXPECT_NE(spread_starts(robot, 5, 7), spread_starts(robot, 5, 8));
}

}  // namespace
}  // namespace morphe::map
