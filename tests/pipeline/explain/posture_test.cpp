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

constexpr double kUpperArm_m = 0.45, kForearm_m = 0.48;
constexpr int kFrames = 20;

/// Two links in the plane z = 0 with a palm at their end.
robot::Robot two_links() {
  RobotModel robot;
  robot.joint_names = {"shoulder", "elbow"};
  robot.lower = JointVector::Constant(2, -3);
  robot.upper = robot.velocity = robot.acceleration = robot.jerk = JointVector::Constant(2, 3);
  const auto at = [](double x) { return Pose(Eigen::Translation3d(x, 0, 0)); };
  robot.frames = {{"upper_arm", -1, at(0), Vec3::UnitZ(), 0, 1, 0},
                  {"forearm", 0, at(kUpperArm_m), Vec3::UnitZ(), 1, 1, 0},
                  {"palm", 1, at(kForearm_m), Vec3::UnitZ(), -1, 1, 0}};
  robot.joint_centres = {{1, "arm"}, {2, "arm"}};
  robot.palm_frame = 2;
  return robot::Robot(std::move(robot));
}

Vec3 unit_at(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

/// Returns the posture of two_links() with the wrist at a point and the elbow bent to the left.
Eigen::Vector2d posture_at(const Vec3& wrist) {
  const double along = wrist.squaredNorm(), a = kUpperArm_m, b = kForearm_m;
  const double elbow = std::acos((along - a * a - b * b) / (2 * a * b));
  const double shoulder =
      std::atan2(wrist.y(), wrist.x()) - std::atan2(b * std::sin(elbow), a + b * std::cos(elbow));
  return {shoulder, elbow};
}

/// A person whose two directions vary, and a trajectory whose wrist is at
///   upper_arm u + forearm f + shift.
Plan plan_with_wrist(double upper_arm, double forearm, const Vec3& shift) {
  Plan plan;
  plan.reason = Reason::none;
  plan.trajectory.position.resize(kFrames, 2);
  for (int k = 0; k < kFrames; ++k) {
    const double share = static_cast<double>(k) / (kFrames - 1);
    const Vec3 u = unit_at(-1 + 0.8 * share), f = unit_at(0.2 + 0.5 * share * share);
    plan.goals.time.push_back(share);
    plan.goals.shoulder_position.push_back(Vec3::Zero());
    plan.goals.elbow_position.push_back(0.28 * u);
    plan.goals.wrist_position.push_back(0.28 * u + 0.25 * f);
    plan.trajectory.position.row(k) = posture_at(upper_arm * u + forearm * f + shift);
  }
  plan.trajectory.time = plan.trajectory.demonstration_time = plan.goals.time;
  plan.certificate.upper_arm_error_mean = plan.certificate.forearm_error_mean = 0.2;
  return plan;
}

TEST(Posture, AShiftedBaseIsThePlacementsFault) {
  const Vec3 shift(0.03, -0.04, 0);
  const PostureSummary found =
      posture_summary(two_links(), plan_with_wrist(kUpperArm_m, kForearm_m, shift));
  EXPECT_NEAR(found.wrist.rms, 0.05, 1e-12);
  EXPECT_LT((found.wrist.base_shift - shift).norm(), 1e-12);
  EXPECT_NEAR(found.wrist.after_shift, 0, 1e-12);
  EXPECT_EQ(found.upper_arm.cause, FigureCause::placement);
  EXPECT_EQ(found.upper_arm.least, found.upper_arm.driven) << "two joints cannot turn the elbow";
}

TEST(Posture, AnotherSizeIsFound) {
  const PostureSummary found = posture_summary(
      two_links(), plan_with_wrist(0.8 * kUpperArm_m, 0.8 * kForearm_m, Vec3(0.03, -0.04, 0)));
  EXPECT_NEAR(found.wrist.upper_arm, kUpperArm_m, 1e-12);
  EXPECT_NEAR(found.wrist.forearm, kForearm_m, 1e-12);
  EXPECT_NEAR(found.wrist.best_scale, 0.8, 1e-9);
  EXPECT_NEAR(found.wrist.after_scale, 0, 1e-9);
  EXPECT_GT(found.wrist.after_shift, 0.005);
}

TEST(Posture, SmallErrorsHaveNoCauseAndAnInfeasiblePlanNoPosture) {
  Plan plan = plan_with_wrist(kUpperArm_m, kForearm_m, Vec3(0.03, 0, 0));
  plan.certificate.upper_arm_error_mean = 0.05;
  EXPECT_EQ(posture_summary(two_links(), plan).upper_arm.cause, FigureCause::small);
  plan.reason = Reason::no_path;
  const PostureSummary none = posture_summary(two_links(), plan);
  EXPECT_TRUE(std::isnan(none.upper_arm.driven));
  EXPECT_EQ(posture_text(plan, none), "");
}

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

TEST(Posture, SevenJointsTurnTheElbowSixDoNot) {
  for (const char* name : {"pa10_dlr_hit2", "iiwa14_allegro", "gen3_robotiq_2f85", "xarm7_leap",
                           "fr3", "rm75_inspire", "wam"})
    EXPECT_TRUE(humanlike::has_elbow_circle(shipped(name), bent_posture(shipped(name)))) << name;
  for (const char* name : {"ur5e_shadow", "arm24_hand5", "dlr_hit2"})
    EXPECT_FALSE(humanlike::has_elbow_circle(shipped(name), bent_posture(shipped(name)))) << name;
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
  // Of a turn about an axis across the line of two held tips, nothing is possible with stiff
  // fingers.
  plan.goals.wrist_orientation = {Quat(Eigen::AngleAxisd(0.3, line.unitOrthogonal())) *
                                  Quat(frames[robot.palm_frame].linear())};
  const PalmFloor floor = palm_floor(robot, plan);
  EXPECT_NEAR(floor.driven, 0.3, 1e-9);
  EXPECT_NEAR(floor.hand_alone, 0.3, 1e-3);
}

}  // namespace
}  // namespace morphe::explain
