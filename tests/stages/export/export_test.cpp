#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/motion/input_error.hpp"
#include "stages/export/robomimic.hpp"
#include "stages/export/ros_trajectory.hpp"
#include "stages/export/trajectory_csv.hpp"

namespace morphe::exports {
namespace {

RobotTable one_joint() {
  RobotTable robot;
  robot.name = "hinge";
  robot.joint_names = {"a \"b\", c"};
  robot.lower = JointVector::Constant(1, -1);
  robot.upper = JointVector::Constant(1, 3);
  return robot;
}

Trajectory three_samples() {
  Trajectory t;
  t.time = {0, 0.1, 1.2500000004};
  t.demonstration_time = {2, 2.5, 3};
  t.position = t.velocity = t.acceleration = JointRows::Zero(3, 1);
  t.position.col(0) << 1e-5, 1.0 / 3, -2;
  t.phase = {PhaseKind::rest, PhaseKind::reach, PhaseKind::grasp};
  return t;
}

TEST(TrajectoryCsv, QuotesNamesAndKeepsEveryDigit) {
  EXPECT_EQ(trajectory_csv(one_joint(), three_samples()),
            "time_s,demonstration_time_s,phase,\"a \"\"b\"\", c_position_rad\","
            "\"a \"\"b\"\", c_velocity_rad_s\",\"a \"\"b\"\", c_acceleration_rad_s2\"\n"
            "0,2,rest,1.0000000000000001e-05,0,0\n"
            "0.10000000000000001,2.5,reach,0.33333333333333331,0,0\n"
            "1.2500000004,3,grasp,-2,0,0\n");
}

TEST(RosTrajectory, WritesWhatYamlReadsAsNumbers) {
  EXPECT_EQ(ros_trajectory(one_joint(), three_samples()),
            "header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: \"base\"\njoint_names:\n"
            "  - \"a \\\"b\\\", c\"\npoints:\n"
            "  -\n    positions: [1.0000000000000001e-05]\n    velocities: [0.0000000000000000]\n"
            "    accelerations: [0.0000000000000000]\n"
            "    time_from_start: {sec: 0, nanosec: 0}\n"
            "  -\n    positions: [0.33333333333333331]\n    velocities: [0.0000000000000000]\n"
            "    accelerations: [0.0000000000000000]\n"
            "    time_from_start: {sec: 0, nanosec: 100000000}\n"
            "  -\n    positions: [-2.0000000000000000]\n    velocities: [0.0000000000000000]\n"
            "    accelerations: [0.0000000000000000]\n"
            "    time_from_start: {sec: 1, nanosec: 250000000}\n");
}

TEST(RosTrajectory, TimeStillIncreasesWhereItIsRoundedAway) {
  Trajectory t = three_samples();
  t.time = {0, 0.9999999999, 0.99999999991};
  const std::string text = ros_trajectory(one_joint(), t);
  EXPECT_NE(text.find("{sec: 1, nanosec: 0}"), std::string::npos);
  EXPECT_NE(text.find("{sec: 1, nanosec: 1}"), std::string::npos);
}

TEST(Robomimic, HoldsOutATenthEvenlySpread) {
  EXPECT_TRUE(validation_demos(0).empty());
  EXPECT_TRUE(validation_demos(1).empty());
  EXPECT_EQ(validation_demos(2), (std::vector<std::size_t>{1}));
  EXPECT_EQ(validation_demos(5), (std::vector<std::size_t>{2}));
  EXPECT_EQ(validation_demos(20), (std::vector<std::size_t>{5, 15}));
}

TEST(Robomimic, AJointWithoutLimitsCannotBeScaled) {
  RobotTable robot = one_joint();
  robot.upper[0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(robomimic_header(robot, 500), InputError);
}

}  // namespace
}  // namespace morphe::exports
