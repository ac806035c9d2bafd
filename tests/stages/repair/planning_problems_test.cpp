#include <gtest/gtest.h>

#include <filesystem>

#include "stages/repair/connect.hpp"
#include "stages/repair/path_smoothing.hpp"
#include "tests/support/moveit_problem.hpp"

namespace morphe::repair {
namespace {

namespace fs = std::filesystem;

/// MotionBenchMaker's first problem of each scenario, which others solve too: the path runs from
/// start to goal, and small steps along it find no two bodies nearer than the margin.
class PlanningProblems : public ::testing::TestWithParam<const char*> {
 protected:
  static moveit::PlanningProblem read(const std::string& set) {
    const fs::path folder = fs::path(MORPHE_SOURCE_DIR) / "datasets/motionbenchmaker";
    return moveit::read_moveit_problem(folder / set / "scene0001.yaml",
                                       folder / set / "request0001.yaml",
                                       robot::load_robot(folder / "panda.yaml"));
  }
};

TEST_P(PlanningProblems, SolvedWithoutTouchingAnything) {
  const moveit::PlanningProblem problem = read(GetParam());
  const robot::Robot robot(problem.robot);
  const collision::CollisionWorld world =
      collision::make_world(robot, problem.scene, {}, Tolerances{});
  const IntervalWorld interval = interval_world(world, 0, 0, 0, TouchRule::strict);
  const ConnectSpace space{robot.arm_joints, robot.lower, robot.upper};
  const JointVector& goal = problem.goals.front().lower;
  const auto plan = [&] {
    auto path = plan_rrt_connect(interval, space, problem.start, goal, 20000, 0.1, 1);
    std::mt19937_64 random(1);
    return shortcut(interval, std::move(path), 30, random);
  };
  const std::vector<JointVector> path = plan();
  ASSERT_GE(path.size(), 2u);
  EXPECT_EQ(path.front(), problem.start);
  EXPECT_EQ(path.back(), goal);
  EXPECT_EQ(path, plan());

  collision::CollisionScratch scratch;
  double least = 1;
  for (std::size_t edge = 1; edge < path.size(); ++edge) {
    const JointVector way = path[edge] - path[edge - 1];
    const int steps = 1 + static_cast<int>(way.cwiseAbs().maxCoeff() / 0.002);
    for (int k = 0; k <= steps; ++k) {
      const JointVector q = path[edge - 1] + way * (static_cast<double>(k) / steps);
      least = std::min(least, collision::least_slack(world, q, 0, scratch).slack());
      ASSERT_TRUE((q.array() >= problem.robot.lower.array() - 1e-12).all());
      ASSERT_TRUE((q.array() <= problem.robot.upper.array() + 1e-12).all());
    }
  }
  EXPECT_GE(least, 0);
}

INSTANTIATE_TEST_SUITE_P(MotionBenchMaker, PlanningProblems,
                         ::testing::Values("bookshelf_small_panda", "bookshelf_tall_panda",
                                           "bookshelf_thin_panda", "box_panda", "cage_panda",
                                           "table_pick_panda", "table_under_pick_panda"));

}  // namespace
}  // namespace morphe::repair
