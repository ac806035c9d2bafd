#include "core/robot/hand_dimensions.hpp"

#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"

namespace morphe::robot {
namespace {

TEST(HandBones, AreTheSumsOfTheLinksFromTheKnucklesAxis) {
  const RobotModel robot = load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table;
  const HandBones bones = hand_dimensions(robot);
  for (const double length : bones.length) EXPECT_NEAR(length, 0.055 + 0.025 + 0.025, 1e-9);
  // Spreading and bending axes meet in the mount of the finger, in the palm's frame.
  EXPECT_LT((bones.knuckle[1] - Vec3(-0.00253, 0.0368, 0.108744)).norm(), 1e-9);
  EXPECT_LT((bones.knuckle[4] - Vec3(0.000972, -0.043396, 0.095044)).norm(), 1e-9);
}

/// A finger along z whose knuckle bends (about y) before it spreads (about x): the axis between two
/// that bend is passed over, and a tip beside the finger, along the axes, adds nothing.
TEST(HandBones, PassOverAnAxisThatSpreadsTheFinger) {
  RobotModel robot;
  robot.joint_names = {"bend", "spread", "middle", "wrist"};
  robot.lower = JointVector::Constant(4, -1);
  robot.upper = JointVector::Constant(4, 2);
  const auto frame = [&](int parent, const Vec3& at, const Vec3& axis, int joint) {
    RobotModel::Frame f;
    f.parent = parent;
    f.transform.translation() = at;
    f.axis = axis;
    f.joint = joint;
    robot.frames.push_back(f);
  };
  frame(-1, Vec3(0, 0, 0.2), Vec3::UnitY(), 3);  // a wrist that bends as the fingers do
  frame(0, Vec3(0.01, 0.03, 0.05), Vec3::UnitY(), 0);
  frame(1, Vec3(0, 0, 0.01), Vec3::UnitX(), 1);
  frame(2, Vec3(0, 0.004, 0.04), Vec3::UnitY(), 2);
  frame(0, Vec3::Zero(), Vec3::UnitZ(), -1);  // the palm, beside the finger
  robot.palm_frame = 4;
  RobotModel::Tip tip;
  tip.frame = 3;
  tip.finger = 2;
  tip.transform.translation() = Vec3(0, 0.015, 0.03);
  robot.tips = {tip};
  const HandBones bones = hand_dimensions(robot);
  EXPECT_NEAR(bones.length[2], 0.05 + 0.03, 1e-12);
  EXPECT_LT((bones.knuckle[2] - Vec3(0.01, 0.03 + 0.004 + 0.015, 0.05)).norm(), 1e-12);
  EXPECT_TRUE(std::isnan(bones.length[0]));
}

}  // namespace
}  // namespace morphe::robot
