#include "pipeline/planning/plan_movement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/goal_interpolation.hpp"
#include "pipeline/planning/plan_parts.hpp"
#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::planning {
namespace {

using testing::HasSubstr;

Plan plan_of(const test::RobotDemonstration& of) {
  Demonstration demonstration;
  demonstration.name = "robot";
  return plan_movement(of.planner(), demonstration, of.motion, of.movement);
}

/// A ball around what a finger touches at the end.
scene::ConfiguredObject ball_at_the_end(const test::RobotDemonstration& of, double radius) {
  scene::ConfiguredObject ball;
  ball.name = "ball";
  ball.shape = "sphere";
  ball.size = {radius};
  ball.position = of.motion.tip(of.motion.time.size() - 1, 1);
  return ball;
}

TEST(PlanMovement, WhatTheRobotCanDoIsPlannedAndMet) {
  constexpr double kNear_m = 2e-3;  // fingers that nearly touch give way to their clearance
  const test::RobotDemonstration of;
  const Plan plan = plan_of(of);
  ASSERT_EQ(plan.reason, Reason::none) << plan.detail;
  EXPECT_LT(plan.certificate.tip_error_max, kNear_m);
  EXPECT_GE(plan.certificate.clearance, plan.tolerances.required_clearance);
  EXPECT_FALSE(plan.repaired);
  EXPECT_GT(plan.certificate.duration_ratio, 0.99);
  for (const auto reachable : plan.goals.reachable.values) EXPECT_EQ(reachable, 1);
  // From the trajectory itself: tips where the person's are, limits kept at every sample.
  std::vector<Pose> frames;
  for (std::size_t i = 0; i < plan.trajectory.samples(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const JointVector q = plan.trajectory.position.row(row).transpose();
    robot::forward_kinematics(of.robot, q, frames);
    for (std::size_t tip = 0; tip < of.robot.tips.size(); ++tip) {
      const Vec3 goal = tip_goal_at(plan.goals, tip, plan.trajectory.demonstration_time[i]);
      EXPECT_LT((robot::tip_pose(of.robot, frames, tip).translation() - goal).norm(), kNear_m);
    }
    EXPECT_TRUE((q.array() >= of.robot.lower.array()).all());
    EXPECT_TRUE((q.array() <= of.robot.upper.array()).all());
    const JointVector speed = plan.trajectory.velocity.row(row).transpose().cwiseAbs();
    EXPECT_TRUE((speed.array() <= of.robot.velocity.array()).all());
  }
}

TEST(PlanMovement, RefusesADoubtfulRecordingUnlessItIsAccepted) {
  test::RobotDemonstration of;
  of.config.audit.refuse = {FlagCode::spike};
  Demonstration demonstration;
  demonstration.name = "robot";
  demonstration.flags = {{FlagCode::spike, FlagResponse::flagged, 0.5, 0.5, "RFTP", 20, 5, "m/s",
                          "RFTP moves at 20 m/s for one frame"}};
  Plan plan = plan_movement(of.planner(), demonstration, of.motion, of.movement);
  EXPECT_EQ(plan.reason, Reason::doubtful_recording);
  EXPECT_EQ(plan.detail, "RFTP moves at 20 m/s for one frame");
  ASSERT_EQ(plan.flags.size(), 1u);
  demonstration.flags[0].response = FlagResponse::accepted;
  plan = plan_movement(of.planner(), demonstration, of.motion, of.movement);
  EXPECT_EQ(plan.reason, Reason::none) << plan.detail;
  EXPECT_EQ(plan.flags.size(), 1u) << "the plan says what was accepted";
}

TEST(PlanMovement, AGraspInsideAnObstacleIsRefusedWithItsTime) {
  test::RobotDemonstration of;
  of.config.scene.objects = {ball_at_the_end(of, 0.05)};
  const Plan plan = plan_of(of);
  EXPECT_EQ(plan.reason, Reason::goal_in_collision) << name_of(plan.reason);
  EXPECT_THAT(plan.detail, AnyOf(HasSubstr("at 1.39 s"), HasSubstr("at 1.4")));
  EXPECT_EQ(plan.trajectory.samples(), 0u);
  EXPECT_FALSE(plan.findings.empty()) << "what the mapping ran into stays on record";
}

TEST(PlanParts, WhatIsExecutableOfAMovementThatFails) {
  test::RobotDemonstration of;
  of.config.scene.objects = {ball_at_the_end(of, 0.05)};
  const std::vector<Plan> parts = plan_parts(of.planner(), {}, of.motion, of.movement, {0.4});
  ASSERT_GT(parts.size(), 1u);
  EXPECT_EQ(parts.front().movement.begin_s, of.movement.begin_s);
  EXPECT_EQ(parts.back().movement.end_s, of.movement.end_s);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Movement& part = parts[k].movement;
    if (k > 0) {
      EXPECT_EQ(part.begin_s, parts[k - 1].movement.end_s) << "nothing is left out";
    }
    if (!parts[k].executable()) {
      EXPECT_LT(part.end_s - part.begin_s, 0.8);
    }
    EXPECT_THAT(parts[k].detail, HasSubstr("of a movement of 2.00 s"));
  }
  EXPECT_TRUE(parts.front().executable()) << parts.front().detail;
  EXPECT_FALSE(parts.back().executable()) << "the ball is there";
}

TEST(PlanParts, AMovementThatSucceedsStaysWhole) {
  test::RobotDemonstration of;
  const std::vector<Plan> parts = plan_parts(of.planner(), {}, of.motion, of.movement, {});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_TRUE(parts.front().executable());
}

TEST(PlanMovement, GoalsThatNoArmReachesAreNotMarkedAsReachable) {
  test::RobotDemonstration of;
  for (Vec3& tip : of.motion.tip.values) tip += Vec3(5, 0, 0);
  const Plan plan = plan_of(of);
  EXPECT_FALSE(plan.executable());
  for (std::size_t tip = 0; tip < of.robot.tips.size(); ++tip) {
    EXPECT_EQ(plan.goals.reachable(0, tip), 0);
  }
}

TEST(PlanMovement, WhatReachesNoGoalIsNeverExecutableWhateverTrackingAllows) {
  test::RobotDemonstration of;
  of.config.map.starts = 4;
  of.config.map.reach_search_starts = 4;
  for (Vec3& tip : of.motion.tip.values) tip += Vec3(1.5, 0, 0);
  of.config.check.tolerances.tracking_tolerance =
      of.config.check.tolerances.tracking_tolerance_grasp = 100;
  of.config.check.tolerances.max_unreachable_share = 0.99;
  of.config.check.tolerances.max_tip_error = 100;
  const Plan plan = plan_of(of);
  EXPECT_NE(plan.status(), Status::executable);
  if (plan.has_trajectory()) {
    EXPECT_THAT(plan.detail, HasSubstr("approximate: "));
  }
}

TEST(PlanMovement, NothingToPlanWith) {
  test::RobotDemonstration of;
  const std::vector<Vec3> shoulder = of.motion.shoulder;
  of.motion.shoulder.assign(shoulder.size(), unknown_point());
  EXPECT_EQ(plan_of(of).reason, Reason::no_shoulder);
  of.motion.shoulder = shoulder;
  for (std::size_t i = 150; i < of.motion.time.size(); ++i) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      of.motion.tip(i, finger) = unknown_point();
    }
  }
  EXPECT_EQ(plan_of(of).reason, Reason::no_goal);
}

TEST(PlanMovement, TheSameTwice) {
  test::RobotDemonstration of;
  of.config.map.starts = 2;
  const Plan one = plan_of(of), two = plan_of(of);
  EXPECT_EQ(one.trajectory.position, two.trajectory.position);
  EXPECT_EQ(one.trajectory.time, two.trajectory.time);
}

}  // namespace
}  // namespace morphe::planning
