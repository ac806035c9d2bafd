// The roles of an arm's joints and its centres, for robots whose joints are known by their makers.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <map>

#include "core/math/random_stream.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/setup.hpp"
#include "tests/core/robot/files/written_urdf.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/pipeline/setup/arm_table.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kMaxCentreDistance_m = 0.005 + 1e-6;

Vec3 axis_of(char letter) {
  const int k = std::tolower(letter) - 'x';
  return k < 0 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Unit(k));
}

/// Returns the URDF of a robot, with its zero position at random joint angles if `bend_rad` is not
/// 0: the axes keep their distances, but not their directions.
std::string urdf_of_table(const TableRobot& robot, double bend_rad) {
  math::RandomStream random(7, robot.name);
  std::string text = fmt::format("<robot name=\"{}\"><link name=\"base_link\"/>", robot.name);
  std::map<std::string, Vec3> origins{{"", Vec3::Zero()}};
  for (const TableJoint& joint : robot.joints) {
    const Vec3 origin(joint.x, joint.y, joint.z);
    const bool turns = joint.axis >= 'x' && joint.axis <= 'z';
    const double angle = turns ? random.uniform(-bend_rad, bend_rad) : 0;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis_of(joint.axis)).toRotationMatrix();
    const Vec3 step = origin - origins.at(joint.parent);
    const Vec3 rpy = turn.eulerAngles(2, 1, 0);  // yaw, pitch, roll
    const std::string parent = joint.parent.empty() ? "base_link" : joint.parent + "_link";
    text += fmt::format(
        "<link name=\"{0}_link\"/><joint name=\"{0}\" type=\"{1}\"><parent link=\"{2}\"/>"
        "<child link=\"{0}_link\"/><origin xyz=\"{3} {4} {5}\" rpy=\"{6} {7} {8}\"/>"
        "<axis xyz=\"{9} {10} {11}\"/><limit lower=\"-2\" upper=\"2\" effort=\"1\" "
        "velocity=\"1\"/></joint>\n",
        joint.name,
        joint.axis == 'f' ? "fixed"
        : turns           ? "revolute"
                          : "prismatic",
        parent, step.x(), step.y(), step.z(), rpy[2], rpy[1], rpy[0], axis_of(joint.axis).x(),
        axis_of(joint.axis).y(), axis_of(joint.axis).z());
    origins[joint.name] = origin;
  }
  return text + "</robot>";
}

struct SetUpRobot {
  robot::RobotDescription description;
  std::vector<Pose> poses;
  SetupResult result;

  Vec3 at(const std::string& frame) const {
    return poses[robot::frame_named(description.table, frame)].translation();
  }
  double distance(const std::string& frame, const std::string& joint) const {
    const int f = description.links.at(joint + "_link");
    const Vec3 axis = poses[f].linear() * description.table.frames[f].axis;
    return (at(frame) - poses[f].translation()).cross(axis).norm();
  }
};

SetUpRobot set_up(const TableRobot& robot, double bend_rad) {
  SetupRequest request;
  request.urdf = robot::write_text(robot.name + ".urdf", urdf_of_table(robot, bend_rad));
  request.out = robot::robot_folder() / "out.yaml";
  if (!robot.arm.empty()) request.arm = robot.arm + "_link";
  SetUpRobot made;
  made.result = make_description(request, std::nullopt);
  made.description = robot::parse_robot(made.result.text, request.out);
  robot::forward_kinematics(made.description.table,
                            JointVector::Zero(made.description.table.lower.size()), made.poses);
  return made;
}

void expect_roles(const TableRobot& robot, const SetUpRobot& made) {
  const auto says = [&](const std::string& text) {
    return made.result.text.find(text) != std::string::npos;
  };
  EXPECT_TRUE(says(fmt::format("{{name: arm, first: {}, ", robot.first)));
  for (const std::string& joint : robot.trunk)
    EXPECT_TRUE(says(fmt::format("{{joint: {}, position: 0}}", joint))) << joint;
  EXPECT_EQ(says("fixed_joints"), !robot.trunk.empty());
  EXPECT_LT(made.distance("elbow_centre", robot.elbow), 1e-6);
  EXPECT_GT((made.at("elbow_centre") - made.at("shoulder_centre")).norm(), 0.05);
  for (const std::string& joint : robot.shoulder)
    EXPECT_LT(made.distance("shoulder_centre", joint), kMaxCentreDistance_m) << joint;
  for (const std::string& joint : robot.wrist)
    EXPECT_LT(made.distance("wrist_centre", joint), kMaxCentreDistance_m) << joint;
}

TEST(FindLimb, RolesAndCentresOfRobotsLikePublicOnes) {
  for (const TableRobot& robot : table_robots()) {
    SCOPED_TRACE(robot.name);
    EXPECT_NO_THROW(expect_roles(robot, set_up(robot, 0)));
  }
}

TEST(FindLimb, RolesDoNotDependOnTheZeroPosition) {
  for (const TableRobot& robot : table_robots()) {
    SCOPED_TRACE(robot.name);
    EXPECT_NO_THROW(expect_roles(robot, set_up(robot, 1.0)));
  }
}

TEST(FindLimb, AsksWhichOfSeveralArms) {
  for (TableRobot robot : table_robots()) {
    if (robot.arm.empty()) continue;
    SCOPED_TRACE(robot.name);
    const std::string arm = robot.arm;
    robot.arm.clear();
    try {
      (void)set_up(robot, 0);
      ADD_FAILURE() << "an arm was chosen";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("has 2 arms: select one with --arm LINK"));
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("\n  {}_link  {}", arm,
                                                      arm.starts_with("l") ? "left" : "right")));
    }
  }
}

/// Returns the robot of the table with this name.
TableRobot table_robot(const std::string& name) {
  for (const TableRobot& robot : table_robots())
    if (robot.name == name) return robot;
  throw InputError(name);
}

TEST(FindLimb, ABipedWithOneArmIsNotAskedAboutItsLegs) {
  TableRobot robot = table_robot("talos");
  robot.arm.clear();
  std::erase_if(robot.joints, [](const TableJoint& j) { return j.name.starts_with("r_a"); });
  expect_roles(robot, set_up(robot, 0));
}

TEST(FindLimb, AnElbowThatCannotBeDerivedIsAskedFor) {
  TableRobot robot{
      "shoulder_only",
      {{"j1", "", 'z', 0, 0, 0.2}, {"j2", "j1", 'y', 0, 0, 0.4}, {"j3", "j2", 'z', 0, 0, 0.6}},
      "",
      "",
      "",
      {},
      {}};
  SetupRequest request;
  request.urdf = robot::write_text("short.urdf", urdf_of_table(robot, 0));
  request.out = robot::robot_folder() / "out.yaml";
  EXPECT_THAT([&] { (void)make_description(request, std::nullopt); },
              testing::ThrowsMessage<InputError>(HasSubstr("--elbow JOINT")));
  request.elbow = "j2";
  EXPECT_THAT(make_description(request, std::nullopt).text,
              HasSubstr("{name: elbow_centre, parent: j2_link"));
}

TEST(FindLimb, TheFlangeIsWhereTheLastLinkEnds) {
  TableRobot robot = table_robot("whole_arm");
  EXPECT_LT((set_up(robot, 0).at("flange") - Vec3(0, 0, 1.25)).norm(), 1e-6);
  robot.joints.push_back({"plate", "a7", 'f', 0, 0, 1.32});
  EXPECT_LT((set_up(robot, 0).at("flange") - Vec3(0, 0, 1.32)).norm(), 1e-6);
  // An arm whose last joint bends the wrist: z continues the forearm.
  const SetUpRobot bent = set_up(table_robot("gr1t2"), 0);
  const Pose& flange = bent.poses[robot::frame_named(bent.description.table, "flange")];
  EXPECT_LT((flange.linear().col(2) + Vec3::UnitZ()).norm(), 1e-6);
}

TEST(FindLimb, WhatFollowsFromAnEditedChainFollowsTheEdit) {
  const TableRobot robot = table_robot("talos");
  SetupRequest request;
  request.urdf = robot::write_text("talos.urdf", urdf_of_table(robot, 0));
  request.out = robot::robot_folder() / "out.yaml";
  request.arm = robot.arm + "_link";
  std::string text = make_description(request, std::nullopt).text;
  EXPECT_EQ(text.find("{joint: l_a1, position"), std::string::npos);
  const std::size_t first = text.find("first: l_a1,");
  ASSERT_NE(first, std::string::npos);
  text.replace(first, 12, "first: l_a2,");
  request.arm.clear();  // the chain says which arm it is
  const SetupResult again = make_description(request, text);
  EXPECT_THAT(again.notes, testing::Contains("kept because edited: chains"));
  EXPECT_THAT(again.text, HasSubstr("{joint: l_a1, position: 0}"));
  EXPECT_THAT(again.text, HasSubstr("{name: arm, first: l_a2, last: l_a7}"));
}

}  // namespace
}  // namespace morphe::setup
