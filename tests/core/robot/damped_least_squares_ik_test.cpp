#include "core/robot/damped_least_squares_ik.hpp"

#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::robot {
namespace {

class DrawTips : public testing::Test {
 protected:
  DrawTips() : robot(load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {}

  Vec3 tip(const JointVector& q, std::size_t i, double tip_to_pad_share = 0) {
    std::vector<Pose> poses;
    forward_kinematics(robot, q, poses);
    return tracked_point(robot, poses, i, tip_to_pad_share);
  }

  Robot robot;
  IkScratch scratch;
};

TEST_F(DrawTips, ToWhereTheRobotHadThemInsideItsLimits) {
  std::mt19937_64 random(4);
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  for (int k = 0; k < 50; ++k) {
    const JointVector there = random_position(robot, random, 1);
    const JointVector start = there + 0.05 * (random_position(robot, random, 1) - middle);
    JointVector q = start.cwiseMax(robot.lower).cwiseMin(robot.upper);
    std::vector<Vec3> places(robot.tips.size(), unknown_point());
    for (const std::size_t i : {0U, 1U, 4U}) places[i] = tip(there, i);
    EXPECT_LT(damped_least_squares_ik(robot, places, {}, 20, 1e-7, q, scratch), 1e-7) << k;
    for (const std::size_t i : {0U, 1U, 4U}) EXPECT_LT((tip(q, i) - places[i]).norm(), 1e-7) << k;
    EXPECT_TRUE((q.array() >= robot.lower.array()).all());
    EXPECT_TRUE((q.array() <= robot.upper.array()).all());
  }
}

TEST_F(DrawTips, PadsOrWhatIsBetweenThemAndTheTips) {
  std::mt19937_64 random(5);
  const JointVector there = random_position(robot, random, 1);
  const std::vector<double> share = {1, 0.3, 0, 0, 1};
  std::vector<Vec3> places(robot.tips.size(), unknown_point());
  for (const std::size_t i : {0U, 1U, 4U}) places[i] = tip(there, i, share[i]);
  EXPECT_GT((places[0] - tip(there, 0)).norm(), 0.005);
  JointVector q = (there.array() + 0.05).matrix().cwiseMax(robot.lower).cwiseMin(robot.upper);
  EXPECT_LT(damped_least_squares_ik(robot, places, share, 20, 1e-7, q, scratch), 1e-7);
  for (const std::size_t i : {0U, 1U, 4U}) {
    EXPECT_LT((tip(q, i, share[i]) - places[i]).norm(), 1e-7) << i;
  }
}

TEST_F(DrawTips, AsNearAsAFingerComesWithoutTheArm) {
  Robot stiff = robot;
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  stiff.lower.head(7) = stiff.upper.head(7) = middle.head(7);
  std::vector<Vec3> places(robot.tips.size(), unknown_point());
  places[1] = tip(middle, 1) + Vec3(0, 0, 1);
  JointVector q = middle;
  const double left = damped_least_squares_ik(stiff, places, {}, 30, 1e-6, q, scratch);
  EXPECT_GT(left, 0.8);
  EXPECT_LT(left, 1.0);
  EXPECT_NEAR(left, (tip(q, 1) - places[1]).norm(), 1e-12);
  EXPECT_EQ(q.head(7), middle.head(7));
}

}  // namespace
}  // namespace morphe::robot
