#include "pipeline/planning/approach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/math/limit_report.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::planning {
namespace {

class Approach : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const test::RobotDemonstration of;
    plan = new Plan(plan_movement(of.planner(), {}, of.motion, of.movement));
  }
  static void TearDownTestSuite() { delete plan; }

  /// Home a little beside the first posture.
  ApproachOptions options() const {
    ApproachOptions options;
    for (std::size_t j = 0; j < 7; ++j) {
      const double first = plan->trajectory.position(0, static_cast<Eigen::Index>(j));
      options.home.push_back({of.robot.joint_names[j], first + (j < 4 ? 0.2 : 0)});
    }
    return options;
  }

  test::RobotDemonstration of;
  static Plan* plan;
};
Plan* Approach::plan = nullptr;

TEST_F(Approach, HomePostureIsZeroOrTheNearestLimitWhereNothingIsSaid) {
  ApproachOptions options;
  options.home = {{of.robot.joint_names[3], 0.7}};
  const JointVector home = home_posture(of.robot, options);
  for (Eigen::Index j = 0; j < home.size(); ++j) {
    const double expected = j == 3 ? 0.7 : std::clamp(0.0, of.robot.lower[j], of.robot.upper[j]);
    EXPECT_EQ(home[j], expected) << j;
  }
}

TEST_F(Approach, LeadsFromHomeToTheFirstSampleAndBackWithinItsShareOfTheLimits) {
  ASSERT_TRUE(plan->executable()) << plan->detail;
  Plan with = *plan;
  const ApproachOptions asked = options();
  const PlanningFailure result = add_approach(of.planner(), asked, 1, with);
  ASSERT_EQ(result.reason, Reason::none) << result.detail;
  const JointVector home = home_posture(of.robot, asked);
  const Trajectory &there = with.approach, &back = with.retreat;
  ASSERT_GT(there.samples(), 2u);
  ASSERT_GT(back.samples(), 2u);
  const auto row = [](const Trajectory& t, Eigen::Index k) -> JointVector {
    return t.position.row(k).transpose();
  };
  EXPECT_LT((row(there, 0) - home).norm(), 1e-6);
  EXPECT_LT((row(there, there.position.rows() - 1) - row(with.trajectory, 0)).norm(), 1e-8);
  EXPECT_LT((row(back, back.position.rows() - 1) - home).norm(), 1e-6);
  for (const Trajectory* way : {&there, &back}) {
    EXPECT_LT(way->velocity.row(0).norm(), 1e-12);
    EXPECT_LT(way->velocity.bottomRows(1).norm(), 1e-12);
    const math::LimitReport use = math::limit_report(of.robot, *way);
    EXPECT_LE(use.velocity.ratio, asked.limit_scaling * (1 + 1e-6));
    EXPECT_LE(use.acceleration.ratio, asked.limit_scaling * (1 + 1e-6));
    EXPECT_LE(use.jerk.ratio, asked.limit_scaling * (1 + 1e-6));
  }
}

TEST_F(Approach, NoneWhereHomeIsInAnObstacle) {
  ASSERT_TRUE(plan->executable()) << plan->detail;
  Plan with = *plan;
  const ApproachOptions asked = options();
  std::vector<Pose> frames;
  robot::forward_kinematics(of.robot, home_posture(of.robot, asked), frames);
  SceneObject ball;
  ball.name = "ball";
  ball.shape = Shape::sphere;
  ball.size = {0.05};
  ball.time = {0};
  ball.position = {robot::tip_pose(of.robot, frames, 1).translation()};
  ball.orientation = {Quat::Identity()};
  with.scene.objects.push_back(ball);
  const PlanningFailure result = add_approach(of.planner(), asked, 1, with);
  EXPECT_EQ(result.reason, Reason::no_approach);
  EXPECT_THAT(result.detail, testing::HasSubstr("ball"));
}

}  // namespace
}  // namespace morphe::planning
