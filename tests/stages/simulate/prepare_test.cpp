#include "stages/simulate/prepare.hpp"

#include <gtest/gtest.h>

#include "core/math/quintic.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/simulate/plan_lift.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

TEST(Prepare, FingersPressAgainstEachOtherWhereTheyTouch) {
  const Plan plan = cup_plan();
  const PreparationResult prepared = prepare(gripper(), plan, SimulateOptions());
  ASSERT_EQ(prepared.skip_reason, SkipReason::none) << prepared.detail;
  const GraspCommand& squeeze = prepared.plan.squeeze;
  ASSERT_EQ(squeeze.finger_forces.size(), 2U);
  // A finger of 10 mm at the end of 80 mm touches a cup of 30 mm whose middle is level with it.
  for (const FingerForce& press : squeeze.finger_forces) {
    EXPECT_NEAR(press.point.head<2>().norm(), 0.03, 1e-6);
    EXPECT_NEAR(press.normal.dot(press.point.normalized()), -1, 1e-6);
    EXPECT_DOUBLE_EQ(press.force_N, 8);
  }
  EXPECT_NEAR(squeeze.closed_posture[1], -squeeze.closed_posture[2], 1e-9);
  std::vector<Pose> frames;
  robot::forward_kinematics(gripper(), squeeze.closed_posture, frames);
  const Vec3 tip = robot::tip_pose(gripper(), frames, 0).translation();
  const Vec3 root = frames[1].translation(), cup(0.08, 0, 0.1);
  const Vec3 along = (tip - root).normalized();
  const double s = std::clamp((cup - root).dot(along), 0.0, 0.08);
  EXPECT_NEAR((root + s * along - cup).norm(), 0.04, 1e-5);
  // The servo's stiffness times how far it aims beyond is the force times its lever.
  const FingerForce& thumb = squeeze.finger_forces[0];
  const Vec3 force = 8 * thumb.normal;
  const Vec3 lever = cup + thumb.point - root;
  EXPECT_NEAR(10 * squeeze.servo_offset[1], lever.cross(force).z(), 1e-6);
  EXPECT_DOUBLE_EQ(squeeze.force_scale, 1);
  EXPECT_DOUBLE_EQ(squeeze.servo_offset[0], 0);
}

TEST(Prepare, ThePlansSqueezeComesFirst) {
  Plan plan = cup_plan();
  add_squeeze(plan);
  SimulateOptions options;
  const PreparationResult stored = prepare(gripper(), plan, options);
  const GraspCommand& squeeze = stored.plan.squeeze;
  EXPECT_TRUE(squeeze.is_planned);
  ASSERT_EQ(squeeze.finger_forces.size(), 2U);  // a contact without a force is none
  EXPECT_EQ(squeeze.finger_forces[0].force_N, 5);
  // Servos of the stiffness that it was planned for are sent where it says.
  const JointVector sent = squeeze.closed_posture + squeeze.servo_offset;
  EXPECT_LT((sent - plan.grasp.servo_target).tail(2).norm(), 1e-12);
  EXPECT_EQ(stored.plan.program.control.row(stored.plan.program.grasp_end - 1).tail(2),
            sent.transpose().tail(2));
  // Softer ones farther, stronger ones no farther than their limit.
  options.hand_stiffness = 5;
  EXPECT_NEAR(prepare(gripper(), plan, options).plan.squeeze.servo_offset[1],
              2 * squeeze.servo_offset[1], 1e-12);
  options = {};
  options.hand_torque_limit = 0.1;
  EXPECT_NEAR(prepare(gripper(), plan, options).plan.squeeze.force_scale, 0.25, 1e-12);
  options = {};
  options.contacts = ContactSource::nearest;
  const PreparationResult nearest = prepare(gripper(), plan, options);
  EXPECT_FALSE(nearest.plan.squeeze.is_planned);
  EXPECT_EQ(nearest.plan.squeeze.finger_forces[0].force_N, 8);
  EXPECT_EQ(nearest.notes.size(), stored.notes.size() + 1);
}

TEST(Prepare, ASqueezeThatIsBrokenIsNone) {
  Plan plan = cup_plan();
  add_squeeze(plan);
  plan.grasp.grasp_torque[1] = kUnknown;
  EXPECT_FALSE(prepare(gripper(), plan, SimulateOptions()).plan.squeeze.is_planned);
  add_squeeze(plan);
  plan.grasp.contacts.pop_back();
  plan.grasp.contacts.pop_back();
  EXPECT_FALSE(prepare(gripper(), plan, SimulateOptions()).plan.squeeze.is_planned);
}

TEST(Prepare, WhatTheMotorsCannotGiveIsTakenFromAllFingers) {
  const Plan plan = cup_plan();
  SimulateOptions options;
  options.force_N = 40;
  const GraspCommand& squeeze = prepare(gripper(), plan, options).plan.squeeze;
  EXPECT_LT(squeeze.force_scale, 0.5);
  EXPECT_NEAR(options.hand_stiffness * squeeze.servo_offset.cwiseAbs().maxCoeff(),
              options.hand_torque_limit, 1e-9);
}

TEST(Prepare, SaysWhyAPlanCannotBeSimulated) {
  const auto skip_reason = [](const Plan& plan, const RobotModel& table = gripper_table()) {
    const robot::Robot robot(table);
    const PreparationResult prepared = prepare(robot, plan, SimulateOptions());
    EXPECT_EQ(prepared.detail.empty(), prepared.skip_reason == SkipReason::none);
    return prepared.skip_reason;
  };
  EXPECT_EQ(skip_reason(cup_plan()), SkipReason::none);
  Plan plan = cup_plan();
  plan.reason = Reason::no_path;
  EXPECT_EQ(skip_reason(plan), SkipReason::infeasible);
  plan = cup_plan();
  plan.movement.target = "plate";
  EXPECT_EQ(skip_reason(plan), SkipReason::no_grasp);
  plan = cup_plan();
  plan.grasp.sample = -1;
  EXPECT_EQ(skip_reason(plan), SkipReason::no_grasp);
  plan = cup_plan();
  plan.trajectory.position(3, 1) = kUnknown;
  EXPECT_EQ(skip_reason(plan), SkipReason::invalid_data);
  plan = cup_plan();
  plan.trajectory.time[5] = plan.trajectory.time[4];
  EXPECT_EQ(skip_reason(plan), SkipReason::invalid_data);
  plan = cup_plan();
  plan.goals.tip_position(0, 0) = unknown_point();
  EXPECT_EQ(skip_reason(plan), SkipReason::no_opposing_fingers);
  RobotModel low = gripper_table();
  low.upper[0] = 0.06;  // it holds the cup at 0 and must come to 0.1
  EXPECT_EQ(skip_reason(cup_plan(), low), SkipReason::lift_infeasible);
}

TEST(Program, FollowsTheQuinticsBetweenTheSamplesUntilTheGraspEnds) {
  Plan plan = cup_plan();
  for (std::size_t k = 45; k < plan.trajectory.samples(); ++k)
    plan.trajectory.phase[k] = PhaseKind::hold;
  EXPECT_EQ(last_tracked_sample(plan), 44U);
  const ServoCommands& program = prepare(gripper(), plan, SimulateOptions()).plan.program;
  EXPECT_EQ(program.tracking_end, 220);  // 0.44 s
  const math::QuinticPiece piece = math::quintic_piece(plan.trajectory, 20, 0);
  const Eigen::Index row = 101;  // after 0.204 s
  EXPECT_NEAR(program.reference(row, 0), math::value_at(piece, 0.004), 1e-12);
  EXPECT_GT(program.reference(row, 0), program.control(row, 0));  // it falls, and is led
  EXPECT_EQ(program.hold_end - program.lift_end, 2500);
}

TEST(Lift, CarriesThePalmStraightUp) {
  const robot::Robot robot(robot::shipped_robot("pa10_dlr_hit2"));
  JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  q[1] = 0.5;
  q[3] = 1.2;
  q[5] = 0.6;
  const Vec3 up(0, 0, 1);
  const std::optional<JointRows> path = plan_lift(robot, q, up, 0.1, 100);
  ASSERT_TRUE(path);
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, q, frames);
  const auto palm = static_cast<std::size_t>(robot.palm_frame);
  const Pose start = frames[palm];
  for (const Eigen::Index row : {24, 49, 99}) {
    robot::forward_kinematics(robot, path->row(row).transpose(), frames);
    const double height = 0.1 * minimum_jerk(static_cast<double>(row + 1) / 100);
    EXPECT_LT((frames[palm].translation() - start.translation() - height * up).norm(), 2e-3);
    EXPECT_LT(angle_between(Quat(start.linear()), Quat(frames[palm].linear())), 5 * kRadPerDegree);
  }
  EXPECT_LT((path->bottomRightCorner(1, 15).transpose() - q.tail(15)).norm(), 1e-12);
}

}  // namespace
}  // namespace morphe::simulate
