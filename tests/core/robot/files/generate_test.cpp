#include "core/robot/files/generate.hpp"

#include <gmock/gmock.h>

#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/generated_products.hpp"
#include "tests/core/robot/files/written_robot.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

using testing::ElementsAre;

constexpr double kHand_m = 0.2, kBreadth_m = 0.09;

double difference(const Pose& ours, const Mat4& expected) {
  return (ours.matrix() - expected).cwiseAbs().maxCoeff();
}

Vec3 origin(const RobotModel& robot, const std::vector<Pose>& frames, int frame) {
  EXPECT_LT(frame, static_cast<int>(robot.frames.size()));
  return frames[static_cast<std::size_t>(frame)].translation();
}

class GeneratedArm : public testing::TestWithParam<int> {};

TEST_P(GeneratedArm, IsTheProductOfItsTurnsAndLinks) {
  const int n = GetParam();
  const RobotModel robot = generate_arm({.joints = n, .length = 0.6});
  ASSERT_EQ(robot.joints(), static_cast<std::size_t>(n));
  ASSERT_EQ(robot.tips.size(), 1u);
  EXPECT_EQ(robot.tips[0].finger, -1);
  std::mt19937 random(1);
  std::vector<Pose> frames;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, frames);
    EXPECT_LT(difference(tip_pose(robot, frames, 0), arm_product(n, 0.6, q)), 1e-12);
  }
}

TEST_P(GeneratedArm, HasItsElbowsAtEqualStepsAndNoneAtTheWrist) {
  const int n = GetParam(), links = n / 3;
  const RobotModel robot = generate_arm({.joints = n, .length = 0.6});
  std::vector<Pose> frames;
  forward_kinematics(robot, zero_position(robot), frames);
  EXPECT_EQ(origin(robot, frames, robot.shoulder_frame), Vec3(0, 0, 0));
  ASSERT_EQ(robot.joint_centres.size(), static_cast<std::size_t>(links - 1));
  for (int k = 1; k < links; ++k) {
    const RobotModel::JointCentre& centre = robot.joint_centres[static_cast<std::size_t>(k - 1)];
    EXPECT_EQ(centre.chain, "arm");
    EXPECT_LT((origin(robot, frames, centre.frame) - Vec3(0, 0, 0.6 * k / links)).norm(), 1e-15);
  }
}

TEST_P(GeneratedArm, WhatIsLeftOfThreeTurnsTheTipWhereItIs) {
  const int n = GetParam();
  const RobotModel robot = generate_arm({.joints = n, .length = 0.6});
  std::mt19937 random(2);
  std::vector<Pose> frames, after;
  JointVector q = random_position(robot, random);
  forward_kinematics(robot, q, frames);
  for (int k = 3 * (n / 3); k < n; ++k) {
    q[k] += 0.5;
    forward_kinematics(robot, q, after);
    const Pose moved = tip_pose(robot, frames, 0).inverse() * tip_pose(robot, after, 0);
    EXPECT_LT(moved.translation().norm(), 1e-14);
    EXPECT_NEAR(Eigen::AngleAxisd(moved.linear()).angle(), 0.5, 1e-12);
    forward_kinematics(robot, q, frames);
  }
}
INSTANTIATE_TEST_SUITE_P(Joints, GeneratedArm,
                         testing::Values(6, 7, 9, 18, 20, 21, 23, 24, 27, 29, 44));

TEST(GeneratedHand, OfFiveFingersHasTheHumansProportionsAndNames) {
  const RobotModel robot = generate_hand({.fingers = 5, .length = kHand_m, .breadth = kBreadth_m});
  EXPECT_EQ(robot.joints(), 20u);
  std::mt19937 random(3);
  std::vector<Pose> frames;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, frames);
    for (const auto& [name, expected] : hand_products(kHand_m, kBreadth_m, q.data())) {
      const std::size_t tip = tip_named(robot, name);
      ASSERT_LT(tip, robot.tips.size());
      EXPECT_LT(difference(tip_pose(robot, frames, tip), expected), 1e-12) << name;
    }
  }
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(robot.tips[i].finger, static_cast<int>(i));
    EXPECT_TRUE(std::isnan(robot.tips[i].finger_curve_share));
  }
}

class GeneratedHandOf : public testing::TestWithParam<int> {};

TEST_P(GeneratedHandOf, AnyNumberOfFingersStandsOnTheSameCurves) {
  const int m = GetParam();
  const RobotModel robot = generate_hand({.fingers = m, .length = kHand_m, .breadth = kBreadth_m});
  EXPECT_EQ(robot.joints(), static_cast<std::size_t>(4 * m));
  ASSERT_EQ(robot.tips.size(), static_cast<std::size_t>(m));
  ASSERT_EQ(robot.joint_centres.size(), static_cast<std::size_t>(m));
  EXPECT_EQ(robot.tips[0].finger, 0);
  EXPECT_EQ(robot.joint_centres[0].chain, "thumb");
  std::mt19937 random(4);
  const JointVector q = random_position(robot, random);
  std::vector<Pose> frames;
  forward_kinematics(robot, q, frames);
  EXPECT_LT(difference(tip_pose(robot, frames, 0), thumb_product(kHand_m, kBreadth_m, q.data())),
            1e-12);
  for (int finger = 1; finger < m; ++finger) {
    const auto tip = static_cast<std::size_t>(finger);
    const double share = (finger - 1.0) / (m - 2);
    EXPECT_EQ(robot.tips[tip].name, "finger" + std::to_string(finger) + "_tip");
    EXPECT_EQ(robot.tips[tip].finger_curve_share, share);
    EXPECT_EQ(robot.tips[tip].finger, 1 + static_cast<int>(std::lround(3 * share)));
    const auto before = std::min<std::size_t>(2, static_cast<std::size_t>(3 * share));
    const FingerRow row =
        mixed(kBuchholz[before], kBuchholz[before + 1], 3 * share - static_cast<double>(before));
    const Mat4 expected = finger_product(row, kHand_m, kBreadth_m, q.data() + 4 * finger);
    EXPECT_LT(difference(tip_pose(robot, frames, tip), expected), 1e-12) << finger;
  }
  EXPECT_TRUE((robot.lower.array() < robot.upper.array()).all());
}
INSTANTIATE_TEST_SUITE_P(Fingers, GeneratedHandOf, testing::Values(3, 4, 6, 8));

TEST(Generated, HandOnArmMakesTheWristACentre) {
  Pose mount = Pose::Identity();
  mount.translation() = Vec3(0, 0, 0.02);
  const RobotModel robot =
      generate_arm_hand({.joints = 6, .length = 0.6},
                        {.fingers = 4, .length = kHand_m, .breadth = kBreadth_m}, mount);
  EXPECT_EQ(robot.name, "arm6_hand4");
  EXPECT_EQ(robot.joints(), 22u);
  EXPECT_EQ(robot.tips.size(), 4u);
  std::vector<std::string> centres;
  for (const auto& c : robot.joint_centres) {
    centres.push_back(c.chain + ":" + robot.frames[static_cast<std::size_t>(c.frame)].name);
  }
  EXPECT_THAT(centres,
              ElementsAre("arm:arm_4", "arm:wrist", "thumb:thumb_mcp", "finger1:finger1_pip",
                          "finger2:finger2_pip", "finger3:finger3_pip"));
  std::mt19937 random(5);
  const JointVector q = random_position(robot, random);
  std::vector<Pose> frames;
  forward_kinematics(robot, q, frames);
  EXPECT_LT(
      difference(tip_pose(robot, frames, 0), arm_product(6, 0.6, q) * shift(0, 0, 0.02) *
                                                 thumb_product(kHand_m, kBreadth_m, q.data() + 6)),
      1e-12);
}

TEST(Generated, AnyHandMountsOnAnyArmByFile) {
  write_robot("four", "name: four\ngenerate: {hand: {fingers: 4, length: 0.2, breadth: 0.09}}\n");
  const std::string pa10 = robot_file("pa10").string();
  const RobotModel on_pa10 = written_robot(
      "on_pa10", "name: on_pa10\nparts:\n  - {file: " + pa10 +
                     "}\n  - {file: four.yaml, parent: flange, mount: {position: [0, 0, 0.02]}}\n");
  EXPECT_EQ(on_pa10.joints(), 23u);
  EXPECT_EQ(on_pa10.tips.size(), 4u);
  const RobotModel dlr = written_robot(
      "dlr", "name: dlr\nparts:\n  - generate: {arm: {joints: 8, length: 0.6}}\n  - {file: " +
                 robot_file("dlr_hit2").string() + ", parent: wrist}\n");
  EXPECT_EQ(dlr.joints(), 23u);  // the paper's 23-DOF arm with hand
  EXPECT_EQ(dlr.tips.size(), 5u);
  EXPECT_EQ(dlr.frames[static_cast<std::size_t>(dlr.palm_frame)].name, "palm");
}

TEST(Generated, FromAFileIsTheFunctionsRobot) {
  const RobotModel file =
      written_robot("a", "name: a\ngenerate: {arm: {joints: 20, length: 0.5, limit: 120 deg}}\n");
  const RobotModel robot = generate_arm({.joints = 20, .length = 0.5, .limit = rad(120)});
  EXPECT_EQ(file.joint_names, robot.joint_names);
  EXPECT_TRUE(file.upper.isApprox(robot.upper, 1e-15));
  ASSERT_EQ(file.frames.size(), robot.frames.size());
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    EXPECT_EQ(file.frames[i].transform.matrix(), robot.frames[i].transform.matrix());
  }
}

TEST(GeneratedEnvelope, CapsulesLieAlongTheLinks) {
  ArmSpec arm;
  arm.joints = 9;
  arm.length = 0.6;
  EXPECT_TRUE(generate_arm(arm).capsules.empty());
  arm.radius = 0.03;
  HandSpec hand;
  hand.fingers = 4;
  hand.length = 0.2;
  hand.breadth = 0.09;
  hand.radius = 0.008;
  const RobotModel robot = generate_arm_hand(arm, hand);
  // Three links; three metacarpals, a thumb of three and three fingers of three.
  ASSERT_EQ(robot.capsules.size(), 3u + 3u + 3u + 9u);
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, JointVector::Zero(9 + 16), base_from_frame);
  for (int k = 0; k < 3; ++k) {
    const RobotModel::Capsule& link = robot.capsules[static_cast<std::size_t>(k)];
    const Pose& pose = base_from_frame[static_cast<std::size_t>(link.frame)];
    EXPECT_TRUE((pose * link.from).isApprox(Vec3(0, 0, 0.2 * k), 1e-12) || k == 0);
    EXPECT_TRUE((pose * link.to).isApprox(Vec3(0, 0, 0.2 * (k + 1)), 1e-12));
    EXPECT_FALSE(link.may_touch_target);
  }
  // Every finger ends at its tip, and may touch what is to be grasped.
  for (const RobotModel::Tip& tip : robot.tips) {
    const auto last = std::ranges::find_if(robot.capsules, [&](const RobotModel::Capsule& capsule) {
      return capsule.frame == tip.frame;
    });
    ASSERT_NE(last, robot.capsules.end());
    EXPECT_LT((last->to - tip.transform.translation()).norm(), 1e-12);
    EXPECT_TRUE(last->may_touch_target);
  }
}

}  // namespace
}  // namespace morphe::robot
