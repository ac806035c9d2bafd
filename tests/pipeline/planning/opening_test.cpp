// A recorded opening of thumb and index that the robot's gripper does not reach.
#include <gmock/gmock.h>

#include "pipeline/planning/plan_sentences.hpp"

namespace morphe::planning {
namespace {

/// Two jaws that slide along y by 0 to 50 mm each, one joint for both: 100 mm between the tips.
RobotModel sliding_jaws() {
  RobotModel robot;
  robot.joint_names = {"slide"};
  robot.lower = JointVector::Constant(1, 0);
  robot.upper = JointVector::Constant(1, 0.05);
  for (const double side : {1.0, -1.0}) {
    RobotModel::Frame frame;
    frame.name = side > 0 ? "one" : "other";
    frame.axis = side * Vec3::UnitY();
    frame.joint = 0;
    frame.prismatic = true;
    robot.frames.push_back(frame);
    RobotModel::Tip tip;
    tip.name = frame.name + "_tip";
    tip.frame = static_cast<int>(robot.frames.size()) - 1;
    tip.finger = tip.frame;
    robot.tips.push_back(tip);
  }
  return robot;
}

Goals goals_apart(double apart_m) {
  Goals goals;
  goals.time = {0, 0.01, 0.02};
  goals.tip_position = Array2D<Vec3>(3, 2, unknown_point());
  for (std::size_t f = 1; f < 3; ++f) {
    goals.tip_position(f, 0) = Vec3(0, 0, 1);
    goals.tip_position(f, 1) = Vec3(0, 0, 1 + apart_m * (f == 1 ? 1 : 0.5));
  }
  return goals;
}

TEST(OpeningWarning, NamesBothFigures) {
  EXPECT_EQ(
      opening_warning(sliding_jaws(), goals_apart(0.112)),
      "thumb and index open 112 mm in the recording, the robot's no more than 100 mm (between "
      "the tips)");
  EXPECT_EQ(opening_warning(sliding_jaws(), goals_apart(0.1)), "");
  EXPECT_EQ(opening_warning(sliding_jaws(), goals_apart(kUnknown)), "");
  RobotModel one_tip = sliding_jaws();
  one_tip.tips.pop_back();
  EXPECT_EQ(opening_warning(one_tip, goals_apart(0.112)), "");
}

}  // namespace
}  // namespace morphe::planning
