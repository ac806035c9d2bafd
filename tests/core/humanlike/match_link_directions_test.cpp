#include "core/humanlike/match_link_directions.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/frame_objective.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/support/finite_differences.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::humanlike {
namespace {

const Vec3 kUpper(0, 0, -1), kFore(0, 0.6, 0.8);
/// Upper arm 0.3, forearm 0.25: the elbow lies at 0.545 of the way.
const Chain kHuman = {Vec3(1, 2, 3), Vec3(1, 2, 3) + 0.3 * kUpper,
                      Vec3(1, 2, 3) + 0.3 * kUpper + 0.25 * kFore};

TEST(PosedLike, TwoLinksPointAsUpperArmAndForearm) {
  const Chain robot = {Vec3(0, 0, 0.3), Vec3(0.45, 0, 0.3), Vec3(0.45, 0.48, 0.3)};
  const Chain posed = match_link_directions(kHuman, robot);
  ASSERT_EQ(posed.size(), 3u);
  EXPECT_EQ(posed[0], robot[0]);
  EXPECT_LT((posed[1] - robot[0] - 0.45 * kUpper).norm(), 1e-15);
  EXPECT_LT((posed[2] - posed[1] - 0.48 * kFore).norm(), 1e-15);
}

/// Seven equal links: the middle of the fourth is at 0.5 of the way, before the elbow.
TEST(PosedLike, ManyLinksTakeTheHumanLinkBesideThem) {
  Chain robot;
  for (int k = 0; k <= 7; ++k) robot.emplace_back(0.1 * k, 0, 0);
  const Chain posed = match_link_directions(kHuman, robot);
  EXPECT_LT((posed[4] - 0.4 * kUpper).norm(), 1e-15);
  EXPECT_LT((posed[7] - posed[4] - 0.3 * kFore).norm(), 1e-15);
}

TEST(PosedLike, AHumanNotSeenGivesNothing) {
  Chain human = kHuman;
  human[1] = unknown_point();
  for (const Vec3& joint : match_link_directions(human, kHuman)) EXPECT_FALSE(is_known(joint));
}

/// What joint-to-joint has in place of the paper's terms, on an arm with a hand.
class JointToJointTerms : public testing::Test {
 protected:
  JointToJointTerms() : robot(robot::generate_arm_hand({9, 0.6}, {4, 0.2, 0.09})) {
    goal.tip_position.assign(robot.tips.size(), unknown_point());
    goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
    goal.finger_joint.fill(unknown_point());
  }
  solve::Quadratic at(const JointVector& q) {
    solve::Quadratic model;
    model.reset(q.size());
    add_objective(objective, robot, q, goal, scratch, model);
    return model;
  }
  void expect_gradient() {
    std::mt19937_64 random(3);
    for (int i = 0; i < 10; ++i) {
      const JointVector q = random_position(robot, random);
      const JointVector numeric =
          numeric_gradient([&](const JointVector& x) { return at(x).value; }, q);
      const solve::Quadratic analytic = at(q);
      EXPECT_GT(analytic.value, 0);
      EXPECT_LT((analytic.gradient - numeric).cwiseAbs().maxCoeff(),
                1e-6 * std::max(1.0, numeric.cwiseAbs().maxCoeff()));
    }
  }
  robot::Robot robot;
  FrameObjective objective;
  FrameGoal goal;
  ObjectiveScratch scratch;
};

TEST_F(JointToJointTerms, ChainPositionHasItsGradient) {
  objective.get<ChainPosition>().weight = 2;
  const JointVector zero = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  EXPECT_EQ(at(zero).value, 0);  // no goals
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, zero, poses);
  goal.chain = arm_chain(robot, poses).joints;
  ASSERT_GT(goal.chain.size(), 2u);
  EXPECT_EQ(at(zero).value, 0);  // there already
  goal.chain[1] += Vec3(0.1, 0, 0);
  goal.chain[2] += Vec3(0, 0.2, 0);
  EXPECT_NEAR(at(zero).value, 2 * (0.01 + 0.04), 1e-12);
  expect_gradient();
}

TEST_F(JointToJointTerms, JointAngleHasItsGradientAndSkipsWhatHasNoGoal) {
  objective.get<JointAngle>().weight = 3;
  goal.angles = JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), kUnknown);
  goal.angles[10] = 0.5;
  goal.angles[11] = -0.2;
  const JointVector zero = JointVector::Zero(goal.angles.size());
  EXPECT_NEAR(at(zero).value, 3 * (0.25 + 0.04), 1e-12);
  EXPECT_NEAR(at(zero).hessian(10, 10), 6, 1e-12);
  EXPECT_EQ(at(zero).hessian(12, 12), 0);
  expect_gradient();
}

/// Four fingers: the thumb's centre has the human thumb's joint, the others the curve's points.
TEST_F(JointToJointTerms, FingersBetweenTheHumansFollowTheCurve) {
  objective.get<FingerJointDistance>().weight = 0.5;
  const JointVector q = JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), 0.1);
  EXPECT_EQ(at(q).value, 0);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  std::vector<Vec3> middle;
  for (const auto& centre : robot.joint_centres) {
    if (centre.chain != "arm") {
      middle.push_back(poses[static_cast<std::size_t>(centre.frame)].translation());
    }
  }
  ASSERT_EQ(middle.size(), 4u);
  goal.finger_joint[0] = middle[0] + Vec3(0.03, 0, 0);
  goal.finger_joint[1] = Vec3(5, 5, 5);  // a finger that this hand has not
  goal.interpolated_finger_joint = {unknown_point(), middle[1] + Vec3(0, 0.02, 0), middle[2],
                                    middle[3] + Vec3(0, 0, 0.01)};
  EXPECT_NEAR(at(q).value, 0.5 * (9e-4 + 4e-4 + 1e-4), 1e-12);
  expect_gradient();
}

/// The finger is that of the tip which a centre moves, whatever its chain is called.
TEST_F(JointToJointTerms, NamesOfFingersDoNotMatter) {
  RobotModel hand = robot::generate_hand({5, 0.2, 0.09});
  for (auto& centre : hand.joint_centres) centre.chain = "f" + centre.chain;
  robot = robot::Robot(hand);
  objective.get<FingerJointDistance>().weight = 1;
  goal.tip_position.assign(robot.tips.size(), unknown_point());
  goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
  const JointVector q = JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), 0.1);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  goal.finger_joint[3] =
      poses[static_cast<std::size_t>(robot.joint_centres[3].frame)].translation() + Vec3(0.1, 0, 0);
  EXPECT_NEAR(at(q).value, 0.01, 1e-12);
}

/// A phase's share of the arm's humanlikeness is one of A, B and C alike.
TEST_F(JointToJointTerms, PhasesWeighAllMetricsOfTheArm) {
  const JointVector q = JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), 0.3);
  goal.shoulder = Vec3::Zero();
  goal.elbow = Vec3(0.1, 0.1, 0.3);
  goal.wrist = Vec3(0.2, -0.1, 0.5);
  const auto value = [&](double a, double b, double c, double share) {
    objective.get<JointDistance>().weight = a;
    objective.get<TriangleArea>().weight = b;
    objective.get<HullVolume>().weight = c;
    goal.weights.humanlike_arm = share;
    return at(q).value;
  };
  for (const std::array<double, 3>& only : {std::array<double, 3>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const double one = value(only[0], only[1], only[2], 1);
    EXPECT_GT(one, 1e-6);
    EXPECT_NEAR(value(only[0], only[1], only[2], 3), 3 * one, 1e-12);
    EXPECT_EQ(value(only[0], only[1], only[2], 0), 0);
  }
}

}  // namespace
}  // namespace morphe::humanlike
