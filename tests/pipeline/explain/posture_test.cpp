#include "pipeline/explain/posture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/humanlike/arm_headroom.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/explain/posture_text.hpp"

namespace morphe::explain {
namespace {

robot::Robot shipped(const std::string& name) {
  return robot::Robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/" + name + ".yaml").table);
}

JointRows bent_posture(const robot::Robot& robot) {
  return (0.6 * robot.lower + 0.4 * robot.upper)
      .cwiseMax(-1)
      .cwiseMin(1)
      .unaryExpr([](double q) { return q == 0 ? 0.3 : q; })
      .transpose();
}

TEST(Posture, AnInfeasiblePlanHasNone) {
  const Plan plan;
  const PostureSummary none = posture_summary(shipped("pa10_dlr_hit2"), plan);
  EXPECT_TRUE(std::isnan(none.upper_arm.driven));
  EXPECT_EQ(posture_text(plan, none), "");
}

TEST(Posture, SevenJointsTurnTheElbowSixDoNot) {
  for (const char* name : {"pa10_dlr_hit2", "iiwa14_allegro", "gen3_robotiq_2f85", "xarm7_leap",
                           "fr3", "rm75_inspire", "wam"})
    EXPECT_TRUE(humanlike::has_elbow_circle(shipped(name), bent_posture(shipped(name)))) << name;
  for (const char* name : {"ur5e_shadow", "arm24_hand5", "dlr_hit2"})
    EXPECT_FALSE(humanlike::has_elbow_circle(shipped(name), bent_posture(shipped(name)))) << name;
}

TEST(Posture, AnElbowThatTheWristDoesNotForceIsDueToWeightsOrSolver) {
  const robot::Robot robot = shipped("pa10_dlr_hit2");
  std::vector<Pose> frames;
  Plan plan;
  plan.reason = Reason::none;
  plan.trajectory.position = bent_posture(robot);
  plan.trajectory.time = plan.trajectory.demonstration_time = plan.goals.time = {0};
  robot::forward_kinematics(robot, plan.trajectory.position.row(0).transpose(), frames);
  humanlike::ArmPoints person = humanlike::arm_points(robot, frames);
  const Vec3 line = (person.wrist - person.shoulder).normalized();
  const Vec3 driven = person.elbow - person.shoulder;
  person.elbow = person.shoulder + Eigen::AngleAxisd(1, line) * driven;
  plan.goals.shoulder_position = {person.shoulder};
  plan.goals.elbow_position = {person.elbow};
  plan.goals.wrist_position = {person.wrist};
  plan.goals.tip_position = Array2D<Vec3>(1, robot.tips.size(), unknown_point());
  plan.certificate.upper_arm_error_mean =
      humanlike::direction_error(driven, person.elbow - person.shoulder);
  const PostureSummary found = posture_summary(robot, plan);
  EXPECT_GT(found.upper_arm.driven, 6 * kRadPerDegree);
  EXPECT_NEAR(found.upper_arm.least, 0, 1e-9);
  EXPECT_THAT(found.upper_arm.causes.all, testing::ElementsAre(FigureCause::weights_or_solver));
  EXPECT_THAT(found.upper_arm.causes.instead, testing::IsEmpty());
}

/// One sample of the reference robot, with goals for thumb and index only.
Plan two_tips(const robot::Robot& robot, const Quat& hand, std::vector<Pose>& frames) {
  Plan plan;
  plan.reason = Reason::none;
  plan.trajectory.position = bent_posture(robot);
  plan.trajectory.time = plan.trajectory.demonstration_time = plan.goals.time = {0};
  robot::forward_kinematics(robot, plan.trajectory.position.row(0).transpose(), frames);
  plan.goals.tip_position = Array2D<Vec3>(1, robot.tips.size(), unknown_point());
  for (int tip = 0; tip < 2; ++tip)
    plan.goals.tip_position(0, tip) = robot::tip_pose(robot, frames, tip).translation();
  plan.goals.wrist_orientation = {hand};
  return plan;
}

TEST(PalmFloor, APalmTurnedAboutTheLineOfTwoTipsNeedsNoAngle) {
  const robot::Robot robot = shipped("pa10_dlr_hit2");
  std::vector<Pose> frames;
  Plan plan = two_tips(robot, Quat::Identity(), frames);
  const Vec3 line = (plan.goals.tip_position(0, 1) - plan.goals.tip_position(0, 0)).normalized();
  plan.goals.wrist_orientation = {Quat(Eigen::AngleAxisd(0.3, line)) *
                                  Quat(frames[robot.palm_frame].linear())};
  const PalmFloor floor = palm_floor(robot, plan);
  EXPECT_NEAR(floor.driven, 0.3, 1e-9);
  EXPECT_LT(floor.hand_alone, 1e-3);
  EXPECT_LT(floor.whole_robot, 1e-3);
  EXPECT_THAT(causes_of_palm(0.3, floor).all, testing::ElementsAre(FigureCause::weights_or_solver));
}

TEST(PalmFloor, FingersThatCannotTurnForceTheirAngle) {
  robot::Robot robot = shipped("pa10_dlr_hit2");
  std::vector<Pose> frames;
  Plan plan = two_tips(robot, Quat::Identity(), frames);
  for (Eigen::Index j = 0; j < robot.lower.size(); ++j) {
    if (std::ranges::find(robot.arm_joints, j) != robot.arm_joints.end()) continue;
    robot.lower[j] = robot.upper[j] = plan.trajectory.position(0, j);
  }
  const Vec3 line = (plan.goals.tip_position(0, 1) - plan.goals.tip_position(0, 0)).normalized();
  // Stiff fingers cannot turn about an axis across the line of two held tips.
  plan.goals.wrist_orientation = {Quat(Eigen::AngleAxisd(0.3, line.unitOrthogonal())) *
                                  Quat(frames[robot.palm_frame].linear())};
  const PalmFloor floor = palm_floor(robot, plan);
  EXPECT_NEAR(floor.driven, 0.3, 1e-9);
  EXPECT_NEAR(floor.hand_alone, 0.3, 1e-3);
  EXPECT_THAT(causes_of_palm(0.3, floor).all, testing::ElementsAre(FigureCause::robot_hand));
}

}  // namespace
}  // namespace morphe::explain
