#include "core/robot/files/description.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/written_robot.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

using testing::ElementsAre;

std::vector<std::string> centres_of(const RobotModel& robot) {
  std::vector<std::string> names;
  for (const RobotModel::JointCentre& centre : robot.joint_centres) {
    names.push_back(centre.chain + ":" + robot.frames[static_cast<std::size_t>(centre.frame)].name);
  }
  return names;
}

bool allowed(const RobotModel& robot, const std::string& first, const std::string& second) {
  const auto index = [&](const std::string& name) {
    const auto found = std::ranges::find(robot.capsules, name, &RobotModel::Capsule::name);
    EXPECT_NE(found, robot.capsules.end()) << name;
    return static_cast<int>(found - robot.capsules.begin());
  };
  const int i = index(first), j = index(second);
  const std::array<int, 2> pair = {std::min(i, j), std::max(i, j)};
  return std::ranges::find(robot.allowed_collision_pairs, pair) !=
         robot.allowed_collision_pairs.end();
}

class Shipped : public testing::TestWithParam<std::string> {};

TEST_P(Shipped, LoadsOnItsOwnAndIsConsistent) {
  const RobotDescription description = load_robot(robot_file(GetParam()));
  const RobotModel& robot = description.table;
  EXPECT_EQ(robot.name, GetParam());
  EXPECT_EQ(description.files.front(), robot_file(GetParam()));
  const auto n = static_cast<Eigen::Index>(robot.joints());
  EXPECT_GT(n, 0);
  for (const JointVector* limit :
       {&robot.lower, &robot.upper, &robot.velocity, &robot.acceleration, &robot.jerk}) {
    ASSERT_EQ(limit->size(), n);
    EXPECT_TRUE(limit->allFinite());
  }
  EXPECT_TRUE((robot.lower.array() < robot.upper.array()).all());
  EXPECT_GT(robot.velocity.minCoeff(), 0);
  EXPECT_GT(robot.acceleration.minCoeff(), 0);
  EXPECT_GT(robot.jerk.minCoeff(), 0);
  const int frames = static_cast<int>(robot.frames.size());
  for (int i = 0; i < frames; ++i) {
    const RobotModel::Frame& frame = robot.frames[static_cast<std::size_t>(i)];
    EXPECT_LT(frame.parent, i);
    EXPECT_LT(frame.joint, n);
    EXPECT_NEAR(frame.axis.norm(), 1, 1e-15);
    EXPECT_TRUE(frame.transform.linear().isUnitary(1e-13));
  }
  EXPECT_FALSE(robot.tips.empty());
  EXPECT_FALSE(robot.joint_centres.empty());
  EXPECT_TRUE(std::ranges::is_sorted(robot.allowed_collision_pairs));
  for (const auto& [i, j] : robot.allowed_collision_pairs) {
    EXPECT_LT(i, j);
    EXPECT_LT(j, static_cast<int>(robot.capsules.size()));
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, Shipped, testing::ValuesIn(shipped_robots()),
                         [](const auto& instance) { return instance.param; });

TEST(Description, TheReferenceRobotIsArmThenHand) {
  const RobotDescription both = load_robot(robot_file("pa10_dlr_hit2"));
  const RobotModel arm = shipped_robot("pa10"), hand = shipped_robot("dlr_hit2");
  std::vector<std::string> joints = arm.joint_names;
  joints.insert(joints.end(), hand.joint_names.begin(), hand.joint_names.end());
  EXPECT_EQ(both.table.joint_names, joints);
  EXPECT_EQ(both.table.frames.size(), arm.frames.size() + hand.frames.size());
  EXPECT_EQ(both.table.capsules.size(), arm.capsules.size() + hand.capsules.size());
  EXPECT_EQ(both.table.tips.size(), 5u);  // the arm's wrist is no end-effector any more
  EXPECT_EQ(both.files.size(), 3u);
  EXPECT_EQ(both.table.frames[static_cast<std::size_t>(both.table.palm_frame)].name, "palm");
  EXPECT_EQ(both.table.frames[static_cast<std::size_t>(both.table.shoulder_frame)].name, "S1");
}

TEST(Description, CentresOfTheArmAloneAndWithTheHand) {
  EXPECT_THAT(centres_of(shipped_robot("pa10")), ElementsAre("arm:E1"));
  EXPECT_THAT(centres_of(shipped_robot("pa10_dlr_hit2")),
              ElementsAre("arm:E1", "arm:W1", "thumb:thumb_middle", "index:index_middle",
                          "middle:middle_middle", "ring:ring_middle", "little:little_middle"));
}

TEST(Description, CentresOfAnArmWithAnOffsetElbow) {
  // Barrett WAM: axes 3 and 4 are 45 mm apart, so the frames of rows 3 and 5 lie beside the elbow.
  std::string yaml = "name: wam\nchains:\n  - name: arm\n    joints:\n";
  const char* rows[] = {"d: 0.31, a: 0, alpha: 0",          "d: 0, a: 0, alpha: -90 deg",
                        "d: 0.55, a: 0, alpha: 90 deg",     "d: 0, a: 0.045, alpha: -90 deg",
                        "d: 0.3, a: -0.045, alpha: 90 deg", "d: 0, a: 0, alpha: -90 deg",
                        "d: 0.06, a: 0, alpha: 90 deg"};
  for (int i = 0; i < 7; ++i) {
    yaml += "      - {name: J" + std::to_string(i + 1) + ", theta: 0, " + rows[i] +
            ", lower: -1, upper: 1, velocity: 1, acceleration: 1, jerk: 1}\n";
  }
  yaml += "tips: [{name: end, chain: arm, finger: wrist}]\n";
  EXPECT_THAT(centres_of(written_robot("wam", yaml)), ElementsAre("arm:J4"));
}

TEST(Description, OnlyPalmAndFingersMayTouchTheTarget) {
  const RobotModel robot = shipped_robot("pa10_dlr_hit2");
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    EXPECT_EQ(capsule.may_touch_target,
              capsule.name.find('_') != std::string::npos &&
                  !capsule.name.starts_with("shoulder") && !capsule.name.starts_with("upper") &&
                  !capsule.name.starts_with("elbow") && !capsule.name.starts_with("forearm"))
        << capsule.name;
  }
}

TEST(Description, PairsThatCanCollideAreNotAllowed) {
  const RobotModel robot = shipped_robot("pa10_dlr_hit2");
  EXPECT_TRUE(allowed(robot, "upper_arm", "elbow_left"));
  EXPECT_TRUE(allowed(robot, "index_proximal", "index_middle"));
  EXPECT_TRUE(allowed(robot, "palm_thumb", "flange"));
  for (const auto& [first, second] :
       std::vector<std::pair<std::string, std::string>>{{"thumb_distal", "index_distal"},
                                                        {"index_proximal", "middle_proximal"},
                                                        {"thumb_proximal", "palm_middle"},
                                                        {"palm_index", "forearm_left"},
                                                        {"palm_middle", "forearm"},
                                                        {"index_distal", "forearm_yoke"},
                                                        {"palm_middle", "upper_arm"},
                                                        {"palm_middle", "base"},
                                                        {"forearm_left", "upper_arm"}}) {
    EXPECT_FALSE(allowed(robot, first, second)) << first << " " << second;
  }
}

TEST(Description, BothConventionsGiveTheSameArm) {
  const std::string limits = "lower: -2, upper: 2, velocity: 1, acceleration: 1, jerk: 1";
  // The same geometry: standard rows hold alpha and a of the next joint's modified row.
  const RobotModel modified = written_robot("modified", R"(
name: modified
convention: modified
chains:
  - name: arm
    joints:
      - {name: a, theta: 0.1, d: 0.3, a: 0, alpha: 0, )" + limits +
                                                            R"(}
      - {name: b, theta: 0, d: 0, a: 0.2, alpha: -90 deg, )" +
                                                            limits + R"(}
      - {name: c, theta: -0.4, d: 0.5, a: 0.1, alpha: 30 deg, )" +
                                                            limits + R"(}
tips: [{name: end, chain: arm, finger: wrist, mount: {position: [0.05, 0, 0], rpy: [20 deg, 0, 0]}}]
)");
  const RobotModel standard = written_robot("standard", R"(
name: standard
convention: modified
chains:
  - name: arm
    convention: standard
    joints:
      - {name: a, theta: 0.1, d: 0.3, a: 0.2, alpha: -90 deg, )" +
                                                            limits + R"(}
      - {name: b, theta: 0, d: 0, a: 0.1, alpha: 30 deg, )" +
                                                            limits + R"(}
      - {name: c, theta: -0.4, d: 0.5, a: 0.05, alpha: 20 deg, )" +
                                                            limits + R"(}
tips: [{name: end, chain: arm, finger: wrist}]
)");
  std::mt19937 random(4);
  std::vector<Pose> first, second;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(modified, random);
    forward_kinematics(modified, q, first);
    forward_kinematics(standard, q, second);
    EXPECT_TRUE(tip_pose(modified, first, 0).isApprox(tip_pose(standard, second, 0), 1e-13));
  }
}

TEST(Description, MountsInEveryForm) {
  const auto mounted = [](const std::string& mount) {
    const RobotModel robot = written_robot(
        "mount", kOneJoint + "frames: [{name: plate, parent: arm, mount: " + mount + "}]\n");
    return robot.frames.at(frame_named(robot, "plate")).transform.matrix();
  };
  const Eigen::Matrix4d rpy = mounted("{position: [1, 2, 3], rpy: [0, 0, 90 deg]}");
  Eigen::Matrix4d expected;
  expected << 0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1;
  EXPECT_TRUE(rpy.isApprox(expected, 1e-15));
  const std::string half = "0.70710678118654757";
  EXPECT_TRUE(mounted("{position: [1, 2, 3], quaternion: [" + half + ", 0, 0, " + half + "]}")
                  .isApprox(expected, 1e-15));
  EXPECT_TRUE(mounted("{position: [1, 2, 3], matrix: [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}")
                  .isApprox(expected, 1e-15));
  EXPECT_TRUE(mounted("{matrix: [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]}")
                  .isApprox(expected, 1e-15));
}

TEST(Description, CentresOfTheFileReplaceTheDerivedOnes) {
  const RobotModel robot =
      written_robot("centres", kOneJoint + "joint_centres: [{frame: turn, chain: arm}]\n");
  EXPECT_THAT(centres_of(robot), ElementsAre("arm:turn"));
}

TEST(Description, CapsulesOnTheBaseOfAPartMoveWithItsMount) {
  write_robot("part", kOneJoint +
                          "collision: {capsules: [{name: foot, frame: base, from: [0, 0, 0], "
                          "to: [0, 0, 1], radius: 0.1}]}\n");
  const RobotModel robot = written_robot(
      "whole", "name: whole\nparts: [{file: part.yaml, mount: {position: [5, 0, 0]}}]\n");
  EXPECT_EQ(robot.capsules.at(0).frame, -1);
  EXPECT_EQ(robot.capsules.at(0).to, Vec3(5, 0, 1));
  EXPECT_EQ(robot.frames.at(0).transform.translation(), Vec3(5, 0, 0));
}

}  // namespace
}  // namespace morphe::robot
