#include "stages/map/joint_to_joint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/human/hand.hpp"
#include "core/humanlike/arm_chain.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/finger_angles.hpp"
#include "stages/map/map_movement.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
constexpr double kDegree = std::numbers::pi / 180;

RobotModel shipped(const std::string& name) {
  return robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/" + name).table;
}

/// Angles inside the human's limits, each finger its own.
JointVector some_angles() {
  const RobotModel human = human::human_hand({0.19, 0.085});
  JointVector angles(static_cast<Index>(kHandAngleCount));
  for (Index k = 0; k < angles.size(); ++k) {
    const double share = 0.3 + 0.4 * std::abs(std::sin(1.7 * static_cast<double>(k)));
    angles[k] = human.lower[k] + share * (human.upper[k] - human.lower[k]);
  }
  return angles;
}

/// A generated hand of five fingers has the human's bones and joints, larger: the angles are the
/// human's own.
TEST(FingerAngles, OfAHandLikeTheHumansAreItsAngles) {
  const robot::Robot robot(robot::generate_hand({5, 0.25, 0.1}));
  FingerAngles fit(robot);
  const JointVector human = some_angles();
  const JointVector q = fit(human);
  ASSERT_EQ(q.size(), human.size());
  for (Index k = 0; k < q.size(); ++k) {
    ASSERT_EQ(robot.joint_names[static_cast<std::size_t>(k)], kHandAngleNames[k]);
    EXPECT_NEAR(q[k], human[k], 1e-4) << kHandAngleNames[k];
  }
}

TEST(FingerAngles, AreThoseOfTheRobotsJointsOnAnArmToo) {
  const robot::Robot robot(robot::generate_arm_hand({9, 0.6}, {5, 0.25, 0.1}));
  FingerAngles fit(robot);
  const JointVector human = some_angles(), q = fit(human);
  ASSERT_EQ(q.size(), 29);
  for (Index k = 0; k < 9; ++k) EXPECT_TRUE(std::isnan(q[k]));
  EXPECT_LT((q.tail(20) - human).cwiseAbs().maxCoeff(), 1e-4);
}

/// The DLR/HIT II's middle finger stands as the human's does, but for 3 degrees of splay: without
/// abduction its flexions are the human's, the coupled last joint following the middle one.
TEST(FingerAngles, OfAnotherHandFlexAsTheHumans) {
  const robot::Robot robot(shipped("dlr_hit2.yaml"));
  FingerAngles fit(robot);
  JointVector human = JointVector::Zero(static_cast<Index>(kHandAngleCount));
  human[8] = 3 * kDegree;  // middle_abduction
  human[9] = 30 * kDegree;
  human[10] = human[11] = 40 * kDegree;
  const JointVector q = fit(human);
  EXPECT_NEAR(q[6], 0, 0.01);
  EXPECT_NEAR(q[7], 30 * kDegree, 0.01);
  EXPECT_NEAR(q[8], 40 * kDegree, 0.01);
  EXPECT_TRUE((q.array() >= robot.lower.array() && q.array() <= robot.upper.array()).all());
}

/// Of four fingers the outer ones are index and little; fingers bent alike leave the one between
/// them bent like that too.
TEST(FingerAngles, BetweenTheHumansFingers) {
  const robot::Robot robot(robot::generate_hand({4, 0.2, 0.09}));
  FingerAngles fit(robot);
  JointVector human = JointVector::Zero(static_cast<Index>(kHandAngleCount));
  for (Index finger = 1; finger < 5; ++finger) {
    human[4 * finger + 1] = 0.5;
    human[4 * finger + 2] = 0.6;
    human[4 * finger + 3] = 0.4;
  }
  const JointVector q = fit(human);
  for (Index finger = 1; finger < 4; ++finger) {
    const double tolerance = finger == 2 ? 0.05 : 0.02;
    EXPECT_NEAR(q[4 * finger + 1], 0.5, tolerance) << finger;
    EXPECT_NEAR(q[4 * finger + 2], 0.6, tolerance) << finger;
    EXPECT_NEAR(q[4 * finger + 3], 0.4, tolerance) << finger;
  }
}

TEST(FingerAngles, AFingerNotSeenHasNone) {
  FingerAngles fit(robot::generate_hand({5, 0.25, 0.1}));
  JointVector human = some_angles();
  human.segment<4>(8).setConstant(kUnknown);
  const JointVector q = fit(human);
  for (Index k = 0; k < 20; ++k) EXPECT_EQ(std::isnan(q[k]), k / 4 == 2) << k;
}

/// A person with the robot's posture and shorter arms: mapped joint to joint, the robot stands as
/// it was, wherever the person's fingertips are.
class ArmToArm : public testing::Test {
 protected:
  ArmToArm() : robot(shipped("pa10_dlr_hit2.yaml")) {
    truth = JointVector::Zero(static_cast<Index>(robot.joints()));
    truth.head(7) << 1.2, -1.0, -1.6, 1.6, 2.5, 0.7, 0.5;
    constexpr std::size_t kFrames = 20;
    goals.tip_position = {kFrames, robot.tips.size(), unknown_point()};
    goals.tip_orientation = {kFrames, robot.tips.size(), unknown_rotation()};
    goals.reachable = {kFrames, robot.tips.size(), 0};
    goals.finger_joint_position = {kFrames, kFingerCount, unknown_point()};
    std::vector<Pose> poses;
    for (std::size_t f = 0; f < kFrames; ++f) {
      JointVector q = truth;
      q[3] += 0.005 * static_cast<double>(f);
      robot::forward_kinematics(robot, q, poses);
      const humanlike::Chain chain = humanlike::arm_chain(robot, poses).joints;
      const Vec3 elbow = chain[0] + 0.6 * (chain[1] - chain[0]);
      goals.time.push_back(0.01 * static_cast<double>(f));
      goals.shoulder_position.push_back(chain[0]);
      goals.elbow_position.push_back(elbow);
      goals.wrist_position.push_back(elbow + 0.5 * (chain[2] - chain[1]));
      goals.wrist_orientation.emplace_back(
          poses[static_cast<std::size_t>(robot.palm_frame)].linear());
      goals.tip_position(f, 1) = chain[2];  // somewhere: to be tracked, and missed
    }
    world = collision::make_world(robot, scene, Movement{}, Tolerances{});
    options.mode = MapMode::joint_to_joint;
    options.starts = 24;
    options.reach_search_starts = 4;
  }
  robot::Robot robot;
  JointVector truth;
  Goals goals;
  Scene scene;
  collision::CollisionWorld world;
  MapOptions options;
};

TEST_F(ArmToArm, LinksAndHandPointAsTheHumans) {
  MappingProblem problem = make_mapping_problem(robot, goals, world, options);
  problem.goals = joint_to_joint_goals(robot, {}, {}, goals);
  const Outcome<MapResult> mapping = map_movement(problem, goals, options, 3);
  ASSERT_FALSE(mapping.failure);
  const MapResult& result = mapping.value;
  std::vector<Pose> poses;
  for (const std::size_t f : {0u, 10u, 19u}) {
    robot::forward_kinematics(robot, result.mapped.position.row(static_cast<Index>(f)).transpose(),
                              poses);
    const humanlike::Chain chain = humanlike::arm_chain(robot, poses).joints;
    const auto angle = [](const Vec3& a, const Vec3& b) {
      return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    EXPECT_LT(angle(chain[1] - chain[0], goals.elbow_position[f] - goals.shoulder_position[f]),
              0.002);
    EXPECT_LT(angle(chain[2] - chain[1], goals.wrist_position[f] - goals.elbow_position[f]), 0.002);
    const Quat palm(poses[static_cast<std::size_t>(robot.palm_frame)].linear());
    EXPECT_LT(angle_between(palm, goals.wrist_orientation[f]), 0.005);
    // The error that is stored is the tip's from its true goal.
    const Vec3 tip = robot::tip_pose(robot, poses, 1).translation();
    EXPECT_NEAR(result.mapped.tip_error(static_cast<Index>(f), 1),
                (tip - goals.tip_position(f, 1)).norm(), 1e-12);
    EXPECT_GT(result.mapped.tip_error(static_cast<Index>(f), 1), 0.05);
  }
  // No angles were recorded: the fingers stay at zero.
  EXPECT_LT(result.mapped.position.rightCols(15).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_THAT(goals.estimated, testing::Contains("finger angles"));
}

TEST_F(ArmToArm, RecordedAnglesAreFollowed) {
  JointRows angles = JointRows::Zero(20, static_cast<Index>(kHandAngleCount));
  angles.col(9).setConstant(0.5);  // middle_mcp
  const std::vector<humanlike::FrameGoal> frames =
      joint_to_joint_goals(robot, angles, goals.time, goals);
  EXPECT_NEAR(frames[7].angles[7 + 7], 0.5, 0.01);  // middle_proximal
  EXPECT_TRUE(std::isnan(frames[7].angles[0]));
  EXPECT_TRUE(goals.estimated.empty());
  EXPECT_EQ(frames[7].goal_tip_count(), 0);
}

}  // namespace
}  // namespace morphe::map
