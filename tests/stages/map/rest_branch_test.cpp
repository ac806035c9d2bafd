#include "stages/map/rest_branch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/robot/arm_branch.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/reference_posture.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// A person whose hand moves 12 cm forward from where the reference has it, in eleven frames.
struct ShortReach {
  explicit ShortReach(const std::string& name)
      : robot(robot::shipped_robot(name)),
        world(collision::make_world(robot, scene, Movement{}, Tolerances{})) {
    reference = find_reference(robot, options, placement, Tolerances{},
                               JointVector::Zero(robot.lower.size()));
    Goals goals;  // only for the options' problem
    problem = make_mapping_problem(robot, goals, world, options);
    problem.reference = reference;
    for (int f = 0; f <= 10; ++f) {
      humanlike::FrameGoal goal = reference.rest;
      const Vec3 moved = 0.012 * f * Vec3(0, 1, 0);
      for (Vec3* point : {&goal.elbow, &goal.wrist}) *point += moved;
      for (Vec3& tip : goal.tip_position) tip += moved;
      problem.goals.push_back(goal);
      problem.time.push_back(0.05 * f);
    }
  }
  ShortReach(const ShortReach&) = delete;

  double largest_tip_error(const JointVector& q, const humanlike::FrameGoal& goal) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    double largest = 0;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      if (!is_known(goal.tip_position[tip])) continue;
      const Vec3 reached = robot::tip_pose(robot, poses, tip).translation();
      largest = std::max(largest, (reached - goal.tip_position[tip]).norm());
    }
    return largest;
  }

  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  PlacementOptions placement{{{"y", 1.8326}, {"z", 1.5708}}, Vec3(0.1, -0.3, 0.3), {}};
  MapOptions options;
  Reference reference;
  MappingProblem problem;
};

TEST(Reference, MeetsTheTipsOfThePersonAtRest) {
  const ShortReach bench("pa10_dlr_hit2");
  ASSERT_FALSE(bench.reference.starts.empty());
  EXPECT_EQ(bench.reference.starts.front(), bench.reference.posture);
  EXPECT_LT(bench.largest_tip_error(bench.reference.posture, bench.reference.rest), 2e-3);
}

TEST(Reference, NoTwoStartsPlaceTheLinksAlike) {
  const ShortReach bench("pa10_dlr_hit2");
  std::vector<Pose> one, other;
  for (std::size_t a = 0; a < bench.reference.starts.size(); ++a) {
    robot::forward_kinematics(bench.robot, bench.reference.starts[a], one);
    for (std::size_t b = 0; b < a; ++b) {
      robot::forward_kinematics(bench.robot, bench.reference.starts[b], other);
      EXPECT_FALSE(one[bench.robot.palm_frame].isApprox(other[bench.robot.palm_frame], 1e-3) &&
                   (one[bench.robot.arm_centres[0]].translation() -
                    other[bench.robot.arm_centres[0]].translation())
                           .norm() < 1e-3);
    }
  }
}

TEST(Reference, IsEmptyForTheBestBranchAndTheConfigsForAPosture) {
  const robot::Robot robot(robot::shipped_robot("pa10_dlr_hit2"));
  MapOptions options;
  options.branch = BranchRule::best;
  const JointVector home = JointVector::Zero(robot.lower.size());
  EXPECT_EQ(find_reference(robot, options, {}, {}, home).posture.size(), 0);
  options.branch = BranchRule::nearest_posture;
  options.branch_posture = {{"E1", "", 1.0}, {"S2", "", 9.0}};
  const JointVector posture = find_reference(robot, options, {}, {}, home).posture;
  EXPECT_EQ(posture[3], 1.0);
  EXPECT_EQ(posture[1], robot.upper[1]);  // moved into the limits
}

TEST(ContinueFromRest, KeepsTheBranchAndMeetsTheTips) {
  ShortReach bench("pa10_dlr_hit2");
  MappingScratch scratch;
  const IkBranch branch =
      continue_from_rest(bench.problem, bench.reference.posture, bench.options, scratch);
  ASSERT_EQ(branch.q.rows(), 11);
  for (Index f = 0; f < branch.q.rows(); ++f)
    EXPECT_LT(bench.largest_tip_error(branch.q.row(f).transpose(), bench.problem.goals[f]), 3e-3);
  const JointRows at_rest = bench.reference.posture.transpose();
  EXPECT_EQ(robot::branch_of_path(bench.robot, branch.q, bench.problem.time).number,
            robot::branch_of_path(bench.robot, at_rest, {0.0}).number);
}

/// A micrometre in the goals moves joints by about a thousandth of a radian at most.
TEST(ContinueFromRest, DependsContinuouslyOnTheGoals) {
  ShortReach bench("pa10_dlr_hit2");
  MappingScratch scratch;
  const auto path = [&] {
    return continue_from_rest(bench.problem, bench.reference.posture, bench.options, scratch).q;
  };
  const JointRows before = path();
  for (humanlike::FrameGoal& goal : bench.problem.goals) {
    for (Vec3& tip : goal.tip_position) tip += Vec3(1e-6, -1e-6, 1e-6);
  }
  EXPECT_LT((path() - before).cwiseAbs().maxCoeff(), 2e-3);
}

}  // namespace
}  // namespace morphe::map
