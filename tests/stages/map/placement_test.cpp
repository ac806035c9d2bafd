#include "stages/map/placement.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"

namespace morphe::map {
namespace {

RobotModel reference_robot() {
  return robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table;
}

PlacementOptions lateral() {
  PlacementOptions options;
  options.rotation = {{"y", 105 * std::numbers::pi / 180}, {"z", std::numbers::pi / 2}};
  options.shoulder_offset = {0.10, -0.30, 0.30};
  return options;
}

/// Three frames of a person whose shoulder moves, thumb and index seen.
HumanMotion small_motion() {
  HumanMotion motion;
  motion.time = {1.00, 1.01, 1.02};
  motion.shoulder = {{0.2, -0.2, 0.3}, {0.21, -0.2, 0.3}, {0.22, -0.2, 0.3}};
  motion.elbow = {{0.25, -0.2, 0.05}, {0.26, -0.2, 0.05}, {0.27, -0.2, 0.05}};
  motion.wrist = {{0.2, 0, 0.05}, {0.2, 0.01, 0.05}, {0.2, 0.02, 0.05}};
  motion.wrist_orientation.assign(3, Quat::Identity());
  motion.tip = {3, kFingerCount, unknown_point()};
  motion.tip_orientation = {3, kFingerCount, unknown_rotation()};
  motion.finger_joint = {3, kFingerCount, unknown_point()};
  for (std::size_t f = 0; f < 3; ++f) {
    motion.tip(f, 0) = Vec3(0.15, 0.1 + 0.01 * static_cast<double>(f), 0.02);
    motion.tip(f, 1) = Vec3(0.20, 0.1 + 0.01 * static_cast<double>(f), 0.02);
  }
  return motion;
}

Movement whole_movement() {
  Movement movement;
  movement.begin_s = 1.00;
  movement.end_s = 1.02;
  return movement;
}

TEST(Placement, TheShouldersStandAtTheOffset) {
  const Vec3 human(0.2, -0.25, 0.3);
  const Pose world_from_base = place_robot(reference_robot(), human, lateral());
  // The PA10's shoulder is 0.317 m above its base.
  const Vec3 robot_shoulder = world_from_base * Vec3(0, 0, 0.317);
  EXPECT_LT((robot_shoulder - human - Vec3(0.10, -0.30, 0.30)).norm(), 1e-12);
}

TEST(Placement, TheBaseAxisPointsRightAndFifteenDegreesDown) {
  const Pose world_from_base = place_robot(reference_robot(), Vec3::Zero(), lateral());
  const double tilt = 15 * std::numbers::pi / 180;
  const Vec3 axis = world_from_base.linear() * Vec3::UnitZ();
  EXPECT_LT((axis - Vec3(std::cos(tilt), 0, -std::sin(tilt))).norm(), 1e-12);
}

TEST(Goals, TipsStayInTheWorldAndTheArmMovesIntoTheCommonBase) {
  const RobotModel robot = reference_robot();
  const HumanMotion motion = small_motion();
  const Pose base_from_world = place_robot(robot, motion.shoulder[0], lateral()).inverse();
  const Goals goals = make_goals(robot, motion, whole_movement(), base_from_world);
  ASSERT_EQ(goals.frames(), 3U);
  EXPECT_LT((base_from_world.inverse() * goals.tip_position(2, 0) - motion.tip(2, 0)).norm(),
            1e-12);
  EXPECT_FALSE(is_known(goals.tip_position(0, 2)));
  // The human shoulder at the begin is the robot's; later it may wander.
  EXPECT_LT((goals.shoulder_position[0] - Vec3(0, 0, 0.317)).norm(), 1e-12);
  EXPECT_NEAR((goals.shoulder_position[2] - goals.shoulder_position[0]).norm(), 0.02, 1e-12);
  // The upper arm keeps length and direction.
  const Vec3 upper_arm = goals.elbow_position[1] - goals.shoulder_position[1];
  const Vec3 recorded = base_from_world.linear() * (motion.elbow[1] - motion.shoulder[1]);
  EXPECT_LT((upper_arm - recorded).norm(), 1e-12);
}

TEST(Goals, AShoulderNeverSeenIsUnseen) {
  HumanMotion motion = small_motion();
  for (Vec3& shoulder : motion.shoulder) shoulder = unknown_point();
  EXPECT_FALSE(is_known(shoulder_at_begin(motion, whole_movement())));
}

TEST(Placement, AHandIsAloneWithoutAnArm) {
  EXPECT_FALSE(is_hand_only(reference_robot()));
  EXPECT_FALSE(is_hand_only(robot::generate_arm({6, 0.6})));
  EXPECT_TRUE(is_hand_only(robot::generate_hand({4, 0.2, 0.09})));
  EXPECT_TRUE(
      is_hand_only(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table));
  RobotModel wrist = robot::generate_hand({5, 0.2, 0.09});
  wrist.frames[static_cast<std::size_t>(wrist.palm_frame)].joint = 0;  // a wrist's joint
  EXPECT_TRUE(is_hand_only(wrist));
  RobotModel unnamed = robot::generate_arm({6, 0.6});  // an arm of which nobody said that it is one
  unnamed.joint_centres.clear();
  EXPECT_FALSE(is_hand_only(unnamed));
}

/// A palm that is not the base's own frame, and is turned in it.
TEST(Placement, APalmStandsWhereTheHumansHandIs) {
  RobotModel robot = robot::generate_hand({5, 0.2, 0.09});
  const Pose base_from_palm =
      make_pose({0.1, 0.2, 0.3}, Quat(Eigen::AngleAxisd(0.8, Vec3(1, 2, 2).normalized())));
  robot.frames[static_cast<std::size_t>(robot.palm_frame)].transform = base_from_palm;
  EXPECT_TRUE((place_hand(robot, {}) * base_from_palm).isApprox(Pose::Identity(), 1e-12));
  PlacementOptions options;
  options.rotation = {{"z", std::numbers::pi / 2}};
  options.shoulder_offset = {0.01, 0.02, 0.03};
  const Pose hand_from_palm = place_hand(robot, options) * base_from_palm;
  EXPECT_LT((hand_from_palm * Vec3(1, 0, 0) - Vec3(0.01, 1.02, 0.03)).norm(), 1e-12);
}

TEST(Goals, AHandAloneNeedsNoArm) {
  const RobotModel robot = robot::generate_hand({5, 0.2, 0.09});
  HumanMotion motion = small_motion();
  motion.shoulder.assign(3, unknown_point());
  motion.elbow.assign(3, unknown_point());
  motion.finger_joint(1, 2) = Vec3(0.01, 0.02, 0.1);
  const Goals goals = make_goals(robot, motion, whole_movement(), Pose::Identity());
  EXPECT_EQ(goals.common_base_offset, Vec3::Zero());
  EXPECT_EQ(goals.tip_position(2, 0), motion.tip(2, 0));
  EXPECT_EQ(goals.finger_joint_position(1, 2), motion.finger_joint(1, 2));
  EXPECT_FALSE(is_known(goals.elbow_position[0]));
}

TEST(PlacementOptions, RefusesAnUnknownAxis) {
  PlacementOptions options;
  options.rotation = {{"w", 1}};
  EXPECT_NE(validation_error(options).find("'w'"), std::string::npos);
}

}  // namespace
}  // namespace morphe::map
