#include "stages/grasp/close_fingers.hpp"

#include <gmock/gmock.h>

#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/closure_goals.hpp"
#include "stages/grasp/measure.hpp"
#include "tests/stages/grasp/rod_before_the_hand.hpp"

namespace morphe::grasp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CloseFingers, UntilThePadTouches) {
  const RodBeforeTheHand of(0.06);
  const FingerClosures closed = close_fingers(of.world, 0.6, {1, 2, 3, 4}, of.q);
  EXPECT_TRUE(closed.open.empty());
  ASSERT_EQ(closed.closings.size(), 4U);
  JointVector q = of.q;
  std::vector<DesiredContact> touches;
  for (const FingerClosure& closing : closed.closings) {
    q += closing.turn;
    touches.push_back(closing.contact);
    EXPECT_GT(closing.turn.cwiseAbs().maxCoeff(), 0.1) << "it had some way to go";
    for (const auto& [joint, sign] : closing_joints(of.robot, of.q, closing.contact.tip)) {
      EXPECT_EQ(sign, 1) << "positive flexion curls the fingers";
      EXPECT_FALSE(of.robot.joint_names[static_cast<std::size_t>(joint)].ends_with("abduction"));
    }
    const Vec3& point = closing.contact.point;
    EXPECT_NEAR(point.head<2>().norm(), 0.02, 1e-9) << "on the rod's side";
    EXPECT_LT(closing.contact.normal.head<2>().dot(point.head<2>()), 0) << "inwards";
  }
  EXPECT_TRUE((q.array() >= of.robot.lower.array()).all());
  EXPECT_TRUE((q.array() <= of.robot.upper.array()).all());
  for (const PadContact& contact : measure_contacts(of.world, touches, q, 0.6)) {
    EXPECT_GE(contact.signed_distance, 0) << contact.tip;
    EXPECT_LT(contact.signed_distance, 2e-5) << contact.tip;
    EXPECT_LT((contact.point - contact.desired_point).norm(), 1e-4) << contact.tip;
  }
}

TEST(CloseFingers, WhatDoesNotReachStaysOpenAndSaysWhy) {
  const RodBeforeTheHand far(0.25);
  const FingerClosures closed = close_fingers(far.world, 0.6, {2}, far.q);
  EXPECT_TRUE(closed.closings.empty());
  ASSERT_EQ(closed.open.size(), 1U);
  EXPECT_EQ(closed.open[0].tip, 2U);
  EXPECT_THAT(closed.open[0].reason, HasSubstr("does not reach"));
}

TEST(CloseFingers, AnInnerLinkThatBeginsInTheTargetStopsTheJointsBeforeItOnce) {
  const RodBeforeTheHand at_the_knuckles(0.02, 0.13);
  const auto proximal = std::ranges::find(at_the_knuckles.robot.capsules, "middle_proximal",
                                          &RobotModel::Capsule::name);
  collision::CollisionScratch scratch;
  collision::update_bodies(at_the_knuckles.world, at_the_knuckles.q, 0.6, scratch);
  const collision::Separation apart = collision::capsule_solid(
      scratch.bodies[static_cast<std::size_t>(proximal - at_the_knuckles.robot.capsules.begin())],
      collision::solid_at(at_the_knuckles.world, 0), scratch.object_poses[0]);
  ASSERT_LT(apart.distance, -0.005);
  const FingerClosures closed = close_fingers(at_the_knuckles.world, 0.6, {2}, at_the_knuckles.q);
  EXPECT_TRUE(closed.closings.empty());
  ASSERT_EQ(closed.open.size(), 1U);
  EXPECT_EQ(closed.open[0].tip, 2U);
  EXPECT_THAT(closed.open[0].reason, HasSubstr("does not reach"));
}

TEST(CloseFingers, GoalsBeginWhereTheFingerIsAndEndOnTheObject) {
  const RodBeforeTheHand of(0.06);
  const FingerClosures closed = close_fingers(of.world, 0.6, {2}, of.q);
  ASSERT_EQ(closed.closings.size(), 1U);
  Goals goals;
  const std::size_t frames = 101;
  for (std::size_t f = 0; f < frames; ++f) goals.time.push_back(0.01 * static_cast<double>(f));
  goals.tip_position = {frames, of.robot.tips.size(), unknown_point()};
  const HoldInterval hold = hold_interval(of.movement);
  JointRows path(frames, of.q.size());
  for (std::size_t f = 0; f < frames; ++f) {
    path.row(static_cast<Eigen::Index>(f)) =
        (of.q + closing_progress(hold, goals.time[f]) * closed.closings[0].turn).transpose();
  }
  EXPECT_THAT(tips_without_goals(of.robot, goals, hold), ElementsAre(0, 1, 2, 3, 4));
  set_closure_goals(of.robot, {closed.closings[0].contact}, of.movement, of.scene.objects[0], path,
                    goals);
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(of.robot, of.q, base_from_frame);
  const Vec3 open = robot::tracked_point(of.robot, base_from_frame, 2, 1);
  EXPECT_FALSE(is_known(goals.tip_position(10, 2))) << "before the hand closes";
  EXPECT_LT((goals.tip_position(21, 2) - open).norm(), 1e-3);
  const Vec3 on_target =
      recorded_pose(of.scene.objects[0], 0.5) * closed.closings[0].contact.centre;
  EXPECT_LT((goals.tip_position(50, 2) - on_target).norm(), 1e-9);
  EXPECT_LT((goals.tip_position(49, 2) - on_target).norm(), 1e-3) << "without a jump";
  EXPECT_EQ(goals.tip_to_pad_share(60, 2), 1);
  EXPECT_THAT(goals.auto_closed, ElementsAre(0, 0, 1, 0, 0));
}

}  // namespace
}  // namespace morphe::grasp
