// Jacobians against central differences of forward(), for every shipped robot and every frame.
#include <gtest/gtest.h>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

constexpr double kStep = 1e-5;

class Jacobian : public testing::TestWithParam<std::string> {
 protected:
  RobotModel robot = shipped_robot(GetParam());
  std::mt19937 random{3};
  std::vector<Pose> at, before, after;

  void move(const JointVector& q, Eigen::Index joint) {
    JointVector moved = q;
    moved[joint] = q[joint] - kStep;
    forward_kinematics(robot, moved, before);
    moved[joint] = q[joint] + kStep;
    forward_kinematics(robot, moved, after);
  }
};

TEST_P(Jacobian, OfAPointMatchesDifferences) {
  const Vec3 point_in_frame(0.03, -0.05, 0.11);
  double worst = 0;
  for (int i = 0; i < 5; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, at);
    for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
      move(q, joint);
      for (std::size_t f = 0; f < robot.frames.size(); ++f) {
        Eigen::Matrix3Xd jacobian = Eigen::Matrix3Xd::Constant(3, q.size(), kUnknown);
        point_jacobian(robot, at, static_cast<int>(f), at[f] * point_in_frame, jacobian);
        const Vec3 expected =
            (after[f] * point_in_frame - before[f] * point_in_frame) / (2 * kStep);
        const double error = (jacobian.col(joint) - expected).norm();
        ASSERT_TRUE(std::isfinite(error));
        worst = std::max(worst, error);
      }
    }
  }
  EXPECT_LT(worst, 1e-7);
}

/// How fast two points of the robot part: by the joints below what both move with.
TEST_P(Jacobian, OfADistanceMatchesDifferences) {
  const Vec3 in_first(0.03, -0.05, 0.11), in_second(-0.02, 0.04, 0.01);
  double worst = 0;
  const JointVector q = random_position(robot, random);
  forward_kinematics(robot, q, at);
  for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
    move(q, joint);
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      for (std::size_t g = 0; g < robot.frames.size(); ++g) {
        const auto away = [&](const std::vector<Pose>& poses) -> Vec3 {
          return poses[f] * in_first - poses[g] * in_second;
        };
        const int first = static_cast<int>(f), second = static_cast<int>(g);
        const int both = common_ancestor(robot, first, second);
        const Vec3 direction = away(at).normalized();
        JointVector slope = JointVector::Zero(q.size());
        add_point_gradient(robot, at, first, both, at[f] * in_first, direction, slope);
        add_point_gradient(robot, at, second, both, at[g] * in_second, -direction, slope);
        const double expected = (away(after).norm() - away(before).norm()) / (2 * kStep);
        worst = std::max(worst, std::abs(slope[joint] - expected));
      }
    }
  }
  EXPECT_LT(worst, 1e-7);
}

TEST_P(Jacobian, OfARotationMatchesDifferences) {
  double worst = 0;
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  for (int i = 0; i < 5; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, at);
    Eigen::MatrixXd all = Eigen::MatrixXd::Constant(6 * tips, q.size(), kUnknown);
    tip_jacobians(robot, at, all);
    for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
      move(q, joint);
      for (Eigen::Index tip = 0; tip < tips; ++tip) {
        const auto f = static_cast<std::size_t>(robot.tips[static_cast<std::size_t>(tip)].frame);
        const Eigen::Matrix3d change =
            (after[f].linear() - before[f].linear()) / (2 * kStep) * at[f].linear().transpose();
        const Vec3 expected(change(2, 1), change(0, 2), change(1, 0));
        const double error = (all.col(joint).segment<3>(6 * tip + 3) - expected).norm();
        ASSERT_TRUE(std::isfinite(error));
        worst = std::max(worst, error);
      }
    }
  }
  EXPECT_LT(worst, 1e-7);
}

TEST_P(Jacobian, OfTheBaseIsZero) {
  const JointVector q = random_position(robot, random);
  forward_kinematics(robot, q, at);
  Eigen::Matrix3Xd jacobian = Eigen::Matrix3Xd::Constant(3, q.size(), kUnknown);
  point_jacobian(robot, at, -1, Vec3(1, 2, 3), jacobian);
  EXPECT_TRUE(jacobian.isZero(0));
}

TEST_P(Jacobian, OfAllTipsAtOnceIsThatOfEach) {
  const JointVector q = random_position(robot, random);
  forward_kinematics(robot, q, at);
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Constant(6 * tips, q.size(), kUnknown);
  tip_jacobians(robot, at, all);
  Eigen::Matrix3Xd point(3, q.size());
  for (Eigen::Index i = 0; i < tips; ++i) {
    const auto tip = static_cast<std::size_t>(i);
    point_jacobian(robot, at, robot.tips[tip].frame, tip_pose(robot, at, tip).translation(), point);
    EXPECT_LT((all.middleRows(6 * i, 3) - point).cwiseAbs().maxCoeff(), 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Jacobian, testing::ValuesIn(shipped_robots()),
                         [](const auto& instance) { return instance.param; });

TEST(CoupledJoint, CountsForTheJointThatDrivesIt) {
  const RobotModel robot = shipped_robot("dlr_hit2");
  std::vector<Pose> at;
  forward_kinematics(robot, zero_position(robot), at);
  const std::size_t distal = frame_named(robot, "index_distal");
  const Vec3 tip = tip_pose(robot, at, tip_named(robot, "index_tip")).translation();
  Eigen::Matrix3Xd jacobian(3, 15);
  point_jacobian(robot, at, static_cast<int>(distal), tip, jacobian);
  // Stretched: 50 mm from the middle joint and 25 mm from the distal one, which turn together.
  EXPECT_NEAR(jacobian.col(5).norm(), 0.050 + 0.025, 1e-15);
  const std::size_t index = tip_named(robot, "index_tip");
  Eigen::MatrixXd all(6 * static_cast<Eigen::Index>(robot.tips.size()), 15);
  tip_jacobians(robot, at, all);
  EXPECT_NEAR(all.col(5).segment<3>(6 * static_cast<Eigen::Index>(index) + 3).norm(), 2, 1e-14);
}

}  // namespace
}  // namespace morphe::robot
