// Joints that slide: poses against a product of elementary motions, Jacobians against differences,
// levers against motions.
#include <gtest/gtest.h>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/robot.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/core/robot/sliding_robot.hpp"

namespace morphe::robot {
namespace {

constexpr double kWay = 1e-5;
const RobotModel kRobot = sliding_robot();

TEST(Sliding, FramesMoveAlongTheirAxes) {
  std::mt19937 random(1);
  std::vector<Pose> frames;
  for (int k = 0; k < 10; ++k) {
    const JointVector q = random_position(kRobot, random);
    forward_kinematics(kRobot, q, frames);
    Pose expected = Pose::Identity();
    for (std::size_t f = 0; f < kRobot.frames.size(); ++f) {
      const RobotModel::Frame& frame = kRobot.frames[f];
      const double value = frame.joint < 0 ? 0 : frame.ratio * q[frame.joint] + frame.offset;
      expected = expected * frame.transform;
      if (frame.prismatic) expected = expected * Eigen::Translation3d(value * frame.axis);
      if (!frame.prismatic) expected = expected * Eigen::AngleAxisd(value, frame.axis);
      EXPECT_LT((frames[f].matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 1e-15);
    }
  }
}

TEST(Sliding, JacobiansMatchDifferences) {
  std::mt19937 random(2);
  std::vector<Pose> at, before, after;
  for (int k = 0; k < 5; ++k) {
    const JointVector q = random_position(kRobot, random);
    forward_kinematics(kRobot, q, at);
    const Vec3 tip = tip_pose(kRobot, at, 0).translation(), direction = Vec3(3, -1, 2).normalized();
    Eigen::Matrix3Xd of_point(3, q.size());
    point_jacobian(kRobot, at, 6, tip, of_point);
    Eigen::MatrixXd of_tips(6, q.size());
    tip_jacobians(kRobot, at, of_tips);
    JointVector slope = JointVector::Zero(q.size());
    add_point_gradient(kRobot, at, 6, -1, tip, direction, slope);
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      forward_kinematics(kRobot, q - kWay * JointVector::Unit(q.size(), j), before);
      forward_kinematics(kRobot, q + kWay * JointVector::Unit(q.size(), j), after);
      const Pose a = tip_pose(kRobot, before, 0), b = tip_pose(kRobot, after, 0);
      const Vec3 moved = (b.translation() - a.translation()) / (2 * kWay);
      const Eigen::AngleAxisd turn(b.linear() * a.linear().transpose());
      const Vec3 turned = turn.angle() * turn.axis() / (2 * kWay);
      EXPECT_LT((of_point.col(j) - moved).norm(), 1e-8);
      EXPECT_LT((of_tips.col(j).head<3>() - moved).norm(), 1e-8);
      EXPECT_LT((of_tips.col(j).tail<3>() - turned).norm(), 1e-8);
      EXPECT_NEAR(slope[j], direction.dot(moved), 1e-8);
    }
  }
}

TEST(Sliding, NoPointTravelsFartherThanItsLevers) {
  const Robot robot(kRobot);
  std::mt19937 random(3);
  std::vector<Pose> a, b;
  double tightest = 0;
  for (int k = 0; k < 2000; ++k) {
    const JointVector from = random_position(robot, random), to = random_position(robot, random);
    forward_kinematics(robot, from, a);
    forward_kinematics(robot, to, b);
    const double allowed = robot.capsule_motion_bounds.row(0).dot((to - from).cwiseAbs());
    for (const Vec3& end : {robot.capsules[0].from, robot.capsules[0].to}) {
      const double travel = (b[6] * end - a[6] * end).norm();
      EXPECT_LE(travel, allowed);
      tightest = std::max(tightest, travel / allowed);
    }
  }
  EXPECT_GT(tightest, 0.3);  // a bound that bounds
}

}  // namespace
}  // namespace morphe::robot
