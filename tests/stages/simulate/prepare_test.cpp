#include "stages/simulate/prepare.hpp"

#include <gtest/gtest.h>

#include "core/math/quintic.hpp"
#include "core/robot/forward.hpp"
#include "stages/simulate/lift.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

TEST(Prepare, FingersPressAgainstEachOtherWhereTheyTouch) {
  const Plan plan = cup_plan();
  const Prepared prepared = prepare(gripper(), plan, SimulateOptions());
  ASSERT_EQ(prepared.unfit, Unfit::none) << prepared.detail;
  const Squeeze& squeeze = prepared.plan.squeeze;
  ASSERT_EQ(squeeze.presses.size(), 2U);
  // A finger of 10 mm at the end of 80 mm touches a cup of 30 mm whose middle is level with it.
  for (const Press& press : squeeze.presses) {
    EXPECT_NEAR(press.point.head<2>().norm(), 0.03, 1e-6);
    EXPECT_NEAR(press.inward.dot(press.point.normalized()), -1, 1e-6);
    EXPECT_DOUBLE_EQ(press.force_N, 8);
  }
  EXPECT_NEAR(squeeze.closed[1], -squeeze.closed[2], 1e-9);
  std::vector<Pose> frames;
  robot::forward(gripper(), squeeze.closed, frames);
  const Vec3 tip = robot::tip_pose(gripper(), frames, 0).translation();
  const Vec3 root = frames[1].translation(), cup(0.08, 0, 0.1);
  const Vec3 along = (tip - root).normalized();
  const double s = std::clamp((cup - root).dot(along), 0.0, 0.08);
  EXPECT_NEAR((root + s * along - cup).norm(), 0.04, 1e-5);
  // The servo's stiffness times how far it aims beyond is the force times its lever.
  const Press& thumb = squeeze.presses[0];
  const Vec3 force = 8 * thumb.inward;
  const Vec3 lever = cup + thumb.point - root;
  EXPECT_NEAR(10 * squeeze.beyond[1], lever.cross(force).z(), 1e-6);
  EXPECT_DOUBLE_EQ(squeeze.force_share, 1);
  EXPECT_DOUBLE_EQ(squeeze.beyond[0], 0);
}

TEST(Prepare, ThePlansSqueezeComesFirst) {
  Plan plan = cup_plan();
  add_squeeze(plan);
  SimulateOptions options;
  const Prepared stored = prepare(gripper(), plan, options);
  const Squeeze& squeeze = stored.plan.squeeze;
  EXPECT_TRUE(squeeze.planned);
  ASSERT_EQ(squeeze.presses.size(), 2U);  // a contact without a force is none
  EXPECT_EQ(squeeze.presses[0].force_N, 5);
  // Servos of the stiffness that it was planned for are sent where it says.
  const JointVector sent = squeeze.closed + squeeze.beyond;
  EXPECT_LT((sent - plan.grasp.squeeze_posture).tail(2).norm(), 1e-12);
  EXPECT_EQ(stored.plan.program.control.row(stored.plan.program.squeezed - 1).tail(2),
            sent.transpose().tail(2));
  // Softer ones farther, stronger ones no farther than their limit.
  options.hand_stiffness = 5;
  EXPECT_NEAR(prepare(gripper(), plan, options).plan.squeeze.beyond[1], 2 * squeeze.beyond[1],
              1e-12);
  options = {};
  options.hand_torque = 0.1;
  EXPECT_NEAR(prepare(gripper(), plan, options).plan.squeeze.force_share, 0.25, 1e-12);
  options = {};
  options.contacts = Contacts::nearest;
  const Prepared nearest = prepare(gripper(), plan, options);
  EXPECT_FALSE(nearest.plan.squeeze.planned);
  EXPECT_EQ(nearest.plan.squeeze.presses[0].force_N, 8);
  EXPECT_EQ(nearest.notes.size(), stored.notes.size() + 1);
}

TEST(Prepare, ASqueezeThatIsBrokenIsNone) {
  Plan plan = cup_plan();
  add_squeeze(plan);
  plan.grasp.squeeze_torque[1] = kNotSeen;
  EXPECT_FALSE(prepare(gripper(), plan, SimulateOptions()).plan.squeeze.planned);
  add_squeeze(plan);
  plan.grasp.contacts.pop_back();
  plan.grasp.contacts.pop_back();
  EXPECT_FALSE(prepare(gripper(), plan, SimulateOptions()).plan.squeeze.planned);
}

TEST(Prepare, WhatTheMotorsCannotGiveIsTakenFromAllFingers) {
  const Plan plan = cup_plan();
  SimulateOptions options;
  options.force_N = 40;
  const Squeeze& squeeze = prepare(gripper(), plan, options).plan.squeeze;
  EXPECT_LT(squeeze.force_share, 0.5);
  EXPECT_NEAR(options.hand_stiffness * squeeze.beyond.cwiseAbs().maxCoeff(), options.hand_torque,
              1e-9);
}

TEST(Prepare, SaysWhyAPlanCannotBeSimulated) {
  const auto unfit = [](const Plan& plan, const RobotTable& table = gripper_table()) {
    const robot::Robot robot(table);
    const Prepared prepared = prepare(robot, plan, SimulateOptions());
    EXPECT_EQ(prepared.detail.empty(), prepared.unfit == Unfit::none);
    return prepared.unfit;
  };
  EXPECT_EQ(unfit(cup_plan()), Unfit::none);
  Plan plan = cup_plan();
  plan.reason = Reason::no_path;
  EXPECT_EQ(unfit(plan), Unfit::infeasible);
  plan = cup_plan();
  plan.movement.target = "plate";
  EXPECT_EQ(unfit(plan), Unfit::no_grasp);
  plan = cup_plan();
  plan.grasp.sample = -1;
  EXPECT_EQ(unfit(plan), Unfit::no_grasp);
  plan = cup_plan();
  plan.trajectory.position(3, 1) = kNotSeen;
  EXPECT_EQ(unfit(plan), Unfit::broken);
  plan = cup_plan();
  plan.trajectory.time[5] = plan.trajectory.time[4];
  EXPECT_EQ(unfit(plan), Unfit::broken);
  plan = cup_plan();
  plan.goals.tip_position(0, 0) = unseen_point();
  EXPECT_EQ(unfit(plan), Unfit::no_squeeze);
  RobotTable low = gripper_table();
  low.upper[0] = 0.06;  // it holds the cup at 0 and must come to 0.1
  EXPECT_EQ(unfit(cup_plan(), low), Unfit::no_lift);
}

TEST(Program, FollowsTheQuinticsBetweenTheSamplesUntilTheGraspEnds) {
  Plan plan = cup_plan();
  for (std::size_t k = 45; k < plan.trajectory.samples(); ++k)
    plan.trajectory.phase[k] = PhaseKind::hold;
  EXPECT_EQ(last_followed(plan), 44U);
  const Program& program = prepare(gripper(), plan, SimulateOptions()).plan.program;
  EXPECT_EQ(program.followed, 220);  // 0.44 s
  const math::QuinticPiece piece = math::quintic_piece(plan.trajectory, 20, 0);
  const Eigen::Index row = 101;  // after 0.204 s
  EXPECT_NEAR(program.reference(row, 0), math::value_at(piece, 0.004), 1e-12);
  EXPECT_GT(program.reference(row, 0), program.control(row, 0));  // it falls, and is led
  EXPECT_EQ(program.held - program.lifted, 2500);
}

TEST(Lift, CarriesThePalmStraightUp) {
  const robot::Robot robot(robot::shipped_robot("pa10_dlr_hit2"));
  JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  q[1] = 0.5;
  q[3] = 1.2;
  q[5] = 0.6;
  const Vec3 up(0, 0, 1);
  const std::optional<JointRows> path = lift(robot, q, up, 0.1, 100);
  ASSERT_TRUE(path);
  std::vector<Pose> frames;
  robot::forward(robot, q, frames);
  const auto palm = static_cast<std::size_t>(robot.palm_frame);
  const Pose start = frames[palm];
  for (const Eigen::Index row : {24, 49, 99}) {
    robot::forward(robot, path->row(row).transpose(), frames);
    const double height = 0.1 * minimum_jerk(static_cast<double>(row + 1) / 100);
    EXPECT_LT((frames[palm].translation() - start.translation() - height * up).norm(), 2e-3);
    EXPECT_LT(angle_between(Quat(start.linear()), Quat(frames[palm].linear())), 5 * kDegree);
  }
  EXPECT_LT((path->bottomRightCorner(1, 15).transpose() - q.tail(15)).norm(), 1e-12);
}

}  // namespace
}  // namespace morphe::simulate
