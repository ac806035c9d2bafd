#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/motion/input_error.hpp"
#include "stages/export/robomimic.hpp"
#include "stages/export/ros_trajectory.hpp"
#include "stages/export/trajectory_csv.hpp"

namespace morphe::exports {
namespace {

RobotModel one_joint() {
  RobotModel robot;
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

JointGroup one_group() { return {"all", {0}, {"a \"b\", c"}, {"rad"}}; }

TEST(TrajectoryCsv, QuotesNamesAndKeepsEveryDigit) {
  EXPECT_EQ(trajectory_csv(one_group(), three_samples()),
            "time_s,demonstration_time_s,phase,\"a \"\"b\"\", c_position_rad\","
            "\"a \"\"b\"\", c_velocity_rad_s\",\"a \"\"b\"\", c_acceleration_rad_s2\"\n"
            "0,2,rest,1e-05,0,0\n"
            "0.1,2.5,reach,0.3333333333333333,0,0\n"
            "1.2500000004,3,grasp,-2,0,0\n");
}

TEST(TrajectoryCsv, AJointThatSlidesIsInMetres) {
  const std::string text = trajectory_csv({"all", {0}, {"finger"}, {"m"}}, three_samples());
  EXPECT_TRUE(
      text.starts_with("time_s,demonstration_time_s,phase,finger_position_m,"
                       "finger_velocity_m_s,finger_acceleration_m_s2\n"))
      << text;
}

TEST(RosTrajectory, WritesWhatYamlReadsAsNumbers) {
  EXPECT_EQ(ros_trajectory_yaml(one_group(), three_samples()),
            "header: {stamp: {sec: 0, nanosec: 0}, frame_id: \"base\"}\n"
            "joint_names: [\"a \\\"b\\\", c\"]\npoints:\n"
            "- {positions: [1.0e-05], velocities: [0.0], accelerations: [0.0], "
            "time_from_start: {sec: 0, nanosec: 0}}\n"
            "- {positions: [0.3333333333333333], velocities: [0.0], accelerations: [0.0], "
            "time_from_start: {sec: 0, nanosec: 100000000}}\n"
            "- {positions: [-2.0], velocities: [0.0], accelerations: [0.0], "
            "time_from_start: {sec: 1, nanosec: 250000000}}\n");
}

TEST(RosTrajectory, IsTheSameAsJson) {
  const auto message = nlohmann::json::parse(ros_trajectory_json(one_group(), three_samples()));
  EXPECT_EQ(message["joint_names"], nlohmann::json::array({"a \"b\", c"}));
  ASSERT_EQ(message["points"].size(), 3u);
  EXPECT_EQ(message["points"][0]["positions"][0], 1e-5);
  EXPECT_EQ(message["points"][2]["time_from_start"]["nanosec"], 250000000);
}

TEST(RosTrajectory, TimeStillIncreasesWhereItIsRoundedAway) {
  Trajectory t = three_samples();
  t.time = {0, 0.9999999999, 0.99999999991};
  const std::string text = ros_trajectory_yaml(one_group(), t);
  EXPECT_NE(text.find("{sec: 1, nanosec: 0}"), std::string::npos);
  EXPECT_NE(text.find("{sec: 1, nanosec: 1}"), std::string::npos);
}

TEST(Robomimic, AJointWithoutLimitsCannotBeScaled) {
  RobotModel robot = one_joint();
  robot.upper[0] = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { robomimic_header(robot, 500, ""); },
              testing::ThrowsMessage<InputError>(
                  testing::StrEq("joint a \"b\", c has no limits to scale actions by")));
}

}  // namespace
}  // namespace morphe::exports
