#include "core/robot/robot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/tree.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Base – 0 – 1 – 2 (palm, fixed) – 3 – 4, and 5 on the palm beside them; joints a, b, c, c, d.
RobotModel branching() {
  RobotModel robot;
  robot.joint_names = {"a", "b", "c", "d"};
  const int parents[] = {-1, 0, 1, 2, 3, 2}, joints[] = {0, 1, -1, 2, 2, 3};
  for (std::size_t f = 0; f < 6; ++f) {
    RobotModel::Frame frame;
    frame.parent = parents[f];
    frame.joint = joints[f];
    robot.frames.push_back(frame);
  }
  robot.palm_frame = 2;
  RobotModel::Tip index, other;
  index.frame = 4;
  index.finger = 1;
  other.frame = 5;
  other.finger = -1;  // no finger's
  robot.tips = {other, index};
  robot.joint_centres = {{1, "arm"}, {3, "index"}, {4, "index"}, {5, "beside"}, {2, "arm"}};
  return robot;
}

TEST(Tree, QuestionsOfABranchingRobot) {
  const RobotModel robot = branching();
  std::vector<int> above;
  for (const int frame : ancestors(robot, 4)) above.push_back(frame);
  EXPECT_THAT(above, ElementsAre(4, 3, 2, 1, 0));
  for (const int frame : ancestors(robot, -1)) ADD_FAILURE() << "the base is no frame: " << frame;
  EXPECT_TRUE(is_in_subtree(robot, 4, 2));
  EXPECT_TRUE(is_in_subtree(robot, 2, 2));
  EXPECT_TRUE(is_in_subtree(robot, 4, -1));
  EXPECT_FALSE(is_in_subtree(robot, 5, 3));
  EXPECT_FALSE(is_in_subtree(robot, 2, 4));
  EXPECT_FALSE(is_in_subtree(robot, -1, 0));
  EXPECT_TRUE(joint_moves_frame(robot, 2, 4));
  EXPECT_FALSE(joint_moves_frame(robot, 2, 5));
  EXPECT_EQ(common_ancestor(robot, 4, 5), 2);
  EXPECT_EQ(common_ancestor(robot, 4, 3), 3);
  EXPECT_EQ(common_ancestor(robot, -1, 3), -1);
}

TEST(Robot, DerivesWhatFollows) {
  const Robot robot(branching());
  EXPECT_THAT(robot.moving_frame, ElementsAre(0, 1, 1, 3, 4, 5));
  EXPECT_THAT(robot.arm_joints, ElementsAre(0, 1));
  EXPECT_THAT(robot.arm_centres, ElementsAre(1, 2));
  EXPECT_THAT(robot.tip_of_centre, ElementsAre(-1, 1, 1, -1, -1));
  EXPECT_THAT(robot.chain_centre_count, ElementsAre(2, 2, 2, 1, 2));
  EXPECT_EQ(robot.capsule_motion_bounds.rows(), 0);
}

TEST(Robot, OfNothingIsNothing) {
  const Robot robot{RobotModel{}};
  EXPECT_THAT(robot.arm_joints, IsEmpty());
  EXPECT_THAT(robot.moving_frame, IsEmpty());
}

TEST(Robot, TheReferenceRobot) {
  const Robot robot(shipped_robot("pa10_dlr_hit2"));
  EXPECT_THAT(robot.arm_joints, ElementsAre(0, 1, 2, 3, 4, 5, 6));
  ASSERT_EQ(robot.arm_centres.size(), 2u);  // elbow and wrist
  for (std::size_t j = 0; j < robot.joint_centres.size(); ++j) {
    const int tip = robot.tip_of_centre[j];
    EXPECT_EQ(tip < 0, robot.joint_centres[j].chain == "arm");
    if (tip < 0) continue;
    EXPECT_EQ(robot.tips[static_cast<std::size_t>(tip)].name,
              robot.joint_centres[j].chain + "_tip");
  }
}

}  // namespace
}  // namespace morphe::robot
