// What urdf_of() writes is the same robot when it is loaded again.
#include <gtest/gtest.h>

#include "core/robot/files/write_urdf.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/written_urdf.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

/// The description of a URDF that urdf_of() wrote; every chain is one of the robot's own.
RobotModel again(const RobotModel& robot) {
  write_text("robot.urdf", urdf_of(robot));
  std::string yaml =
      "name: " + robot.name +
      "\nurdf: {file: robot.urdf, acceleration: 1, jerk: 1}\nchains:\n  - {name: all, first: " +
      robot.frames.front().name + ", last: " + robot.frames.front().name + "}\n";
  yaml += "palm: " + robot.frames[static_cast<std::size_t>(robot.palm_frame)].name + "\ntips:\n";
  for (const RobotModel::Tip& tip : robot.tips) {
    const bool taken = frame_named(robot, tip.name) < robot.frames.size();
    yaml += "  - {name: " + tip.name + ", frame: " + tip.name + (taken ? "_tip" : "") +
            ", finger: " + (tip.finger < 0 ? "wrist" : std::to_string(tip.finger)) + "}\n";
  }
  return written_robot("robot", yaml);
}

class RoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, EveryFrameStandsWhereItStood) {
  const RobotModel robot = shipped_robot(GetParam()), loaded = again(robot);
  ASSERT_EQ(loaded.joint_names, robot.joint_names);
  EXPECT_EQ(loaded.lower, robot.lower);
  EXPECT_EQ(loaded.upper, robot.upper);
  EXPECT_EQ(loaded.velocity, robot.velocity);
  std::mt19937 random(1);
  std::vector<Pose> before, after;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    forward_kinematics(robot, q, before);
    forward_kinematics(loaded, q, after);
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      const std::size_t same = frame_named(loaded, robot.frames[f].name);
      ASSERT_LT(same, loaded.frames.size());
      EXPECT_LT((after[same].matrix() - before[f].matrix()).cwiseAbs().maxCoeff(), 1e-12);
    }
    for (std::size_t t = 0; t < robot.tips.size(); ++t) {
      const Eigen::Matrix4d change =
          tip_pose(loaded, after, t).matrix() - tip_pose(robot, before, t).matrix();
      EXPECT_LT(change.cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST_P(RoundTrip, EveryCapsuleIsTheSame) {
  const RobotModel robot = shipped_robot(GetParam()), loaded = again(robot);
  ASSERT_EQ(loaded.capsules.size(), robot.capsules.size());
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    const auto same = std::ranges::find(loaded.capsules, capsule.name, &RobotModel::Capsule::name);
    ASSERT_NE(same, loaded.capsules.end()) << capsule.name;
    EXPECT_NEAR(same->radius, capsule.radius, 1e-15);
    const double straight = (same->from - capsule.from).norm() + (same->to - capsule.to).norm();
    EXPECT_LT(straight, 1e-12) << capsule.name;
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, RoundTrip, testing::ValuesIn(shipped_robots()),
                         [](const auto& instance) { return instance.param; });

TEST(WrittenUrdf, AHandFromAUrdfMountsOnAnArm) {
  write_text("hand.urdf", urdf_of(shipped_robot("dlr_hit2")));
  write_robot("hand", R"(name: hand
urdf: {file: hand.urdf, acceleration: 31.4, jerk: 314}
chains:
  - {name: thumb, first: thumb_abduction, last: thumb_distal}
  - {name: index, first: index_abduction, last: index_distal}
palm: palm
tips:
  - {name: thumb_tip, frame: thumb_tip, finger: thumb}
  - {name: index_tip, frame: index_tip, finger: index}
)");
  const RobotModel robot = written_robot(
      "both", "name: both\nparts:\n  - {file: " + robot_file("pa10").string() +
                  "}\n  - {file: hand.yaml, parent: flange, mount: {position: [0, 0, 0.03]}}\n");
  const RobotModel shipped = shipped_robot("pa10_dlr_hit2");
  // The other fingers carry no tip: they are held.
  const std::vector<std::string> driven(shipped.joint_names.begin(),
                                        shipped.joint_names.begin() + 13);
  ASSERT_EQ(robot.joint_names, driven);
  std::mt19937 random(2);
  const JointVector whole = random_position(shipped, random);
  std::vector<Pose> ours, theirs;
  forward_kinematics(robot, whole.head(13), ours);
  forward_kinematics(shipped, whole, theirs);
  for (std::size_t tip = 0; tip < 2; ++tip) {
    EXPECT_LT((tip_pose(robot, ours, tip).matrix() - tip_pose(shipped, theirs, tip).matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
  }
  ASSERT_EQ(robot.joint_centres.size(), 4u);  // elbow, wrist and the two fingers' middle joints
  EXPECT_EQ(robot.frames[static_cast<std::size_t>(robot.joint_centres[3].frame)].name,
            "index_middle");
}

}  // namespace
}  // namespace morphe::robot
