#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "pipeline/kinematics/forward.hpp"
#include "pipeline/kinematics/write_urdf.hpp"
#include "pipeline/motion/input_error.hpp"
#include "tests/pipeline/kinematics/generated_products.hpp"
#include "tests/pipeline/kinematics/shipped_robots.hpp"
#include "tests/pipeline/kinematics/written_robot.hpp"

namespace morphe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::filesystem::path write_text(const std::string& name, const std::string& text) {
  const std::filesystem::path file = robot_folder() / name;
  std::ofstream(file) << text;
  return file;
}

/// The description of a URDF that urdf_of() wrote; every chain is one of the robot's own.
RobotTable again(const RobotTable& robot) {
  write_text("robot.urdf", urdf_of(robot));
  std::string yaml =
      "name: " + robot.name +
      "\nurdf: {file: robot.urdf, acceleration: 1, jerk: 1}\nchains:\n  - {name: all, first: " +
      robot.frames.front().name + ", last: " + robot.frames.front().name + "}\n";
  yaml += "palm: " + robot.frames[static_cast<std::size_t>(robot.palm_frame)].name + "\ntips:\n";
  for (const RobotTable::Tip& tip : robot.tips) {
    const bool taken = frame_named(robot, tip.name) < robot.frames.size();
    yaml += "  - {name: " + tip.name + ", frame: " + tip.name + (taken ? "_tip" : "") +
            ", finger: " + (tip.finger < 0 ? "wrist" : std::to_string(tip.finger)) + "}\n";
  }
  return written_robot("robot", yaml);
}

class RoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, EveryFrameStandsWhereItStood) {
  const RobotTable robot = shipped_robot(GetParam()), loaded = again(robot);
  ASSERT_EQ(loaded.joint_names, robot.joint_names);
  EXPECT_EQ(loaded.lower, robot.lower);
  EXPECT_EQ(loaded.upper, robot.upper);
  EXPECT_EQ(loaded.velocity, robot.velocity);
  std::mt19937 random(1);
  std::vector<Pose> before, after;
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    forward(robot, q, before);
    forward(loaded, q, after);
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
  const RobotTable robot = shipped_robot(GetParam()), loaded = again(robot);
  ASSERT_EQ(loaded.capsules.size(), robot.capsules.size());
  for (const RobotTable::Capsule& capsule : robot.capsules) {
    const auto same = std::ranges::find(loaded.capsules, capsule.name, &RobotTable::Capsule::name);
    ASSERT_NE(same, loaded.capsules.end()) << capsule.name;
    EXPECT_NEAR(same->radius, capsule.radius, 1e-15);
    const double straight = (same->from - capsule.from).norm() + (same->to - capsule.to).norm();
    EXPECT_LT(straight, 1e-12) << capsule.name;
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, RoundTrip, testing::ValuesIn(shipped_robots()),
                         [](const auto& instance) { return instance.param; });

const std::string kUrdf = R"(<?xml version="1.0"?>
<robot name="two">
  <link name="stand">
    <collision><geometry><box size="0.1 0.4 0.1"/></geometry></collision>
  </link>
  <joint name="a" type="revolute">
    <parent link="stand"/>
    <child link="upper"/>
    <origin xyz="0 0 1" rpy="0.1 0.2 0.3"/>
    <axis xyz="0 2 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="2"/>
  </joint>
  <link name="upper">
    <collision><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.05" length="0.4"/></geometry></collision>
  </link>
  <joint name="plate" type="fixed">
    <parent link="lower"/>
    <child link="tool"/>
    <origin xyz="0 0 0.1"/>
  </joint>
  <joint name="b" type="continuous">
    <parent link="upper"/>
    <child link="lower"/>
    <origin xyz="0 0 0.4"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="lower">
    <collision name="ball"><geometry><sphere radius="0.06"/></geometry></collision>
  </link>
  <joint name="c" type="revolute">
    <parent link="lower"/>
    <child link="finger"/>
    <origin xyz="0 0 0.3"/>
    <axis xyz="1 0 0"/>
    <limit lower="-3" upper="3" effort="1" velocity="2"/>
    <mimic joint="d" multiplier="2" offset="0.5"/>
  </joint>
  <joint name="d" type="revolute">
    <parent link="tool"/>
    <child link="other"/>
    <axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="2"/>
    <mimic joint="a" multiplier="-1" offset="0.25"/>
  </joint>
  <link name="finger"/>
  <link name="tool"/>
  <link name="other"/>
</robot>
)";
const std::string kDescription = R"(name: two
urdf:
  file: two.urdf
  srdf: two.srdf
  acceleration: 5
  jerk: 50
  limits:
    - {joint: b, lower: -90 deg, upper: 90 deg, velocity: 3, jerk: 70}
chains:
  - {name: arm, first: a, last: tool}
palm: tool
tips:
  - {name: end, frame: finger, finger: index, mount: {position: [0, 0, 0.1]}}
collision:
  may_touch_target: [ball]
)";
const std::string kSrdf = R"(<robot name="two">
  <disable_collisions link1="stand" link2="lower" reason="Never"/>
</robot>
)";

TEST(Urdf, JointsInTheFilesOrderBehindTheirParents) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotDescription description = load_robot(write_robot("two", kDescription));
  const RobotTable& robot = description.table;
  EXPECT_EQ(description.files.size(), 3u);
  EXPECT_THAT(robot.joint_names, ElementsAre("a", "b"));
  std::vector<std::string> frames;
  for (const auto& frame : robot.frames) frames.push_back(frame.name);
  EXPECT_THAT(frames, ElementsAre("a", "b", "tool", "c", "d"));
  EXPECT_THAT(std::vector(robot.upper.begin(), robot.upper.end()),
              ElementsAre(1, testing::DoubleNear(rad(90), 1e-15)));
  EXPECT_THAT(std::vector(robot.velocity.begin(), robot.velocity.end()), ElementsAre(2, 3));
  EXPECT_THAT(std::vector(robot.acceleration.begin(), robot.acceleration.end()), ElementsAre(5, 5));
  EXPECT_THAT(std::vector(robot.jerk.begin(), robot.jerk.end()), ElementsAre(50, 70));
  EXPECT_EQ(robot.shoulder_frame, 0);
  EXPECT_EQ(robot.palm_frame, 2);
  ASSERT_EQ(robot.centres.size(), 1u);  // the elbow: both joints turn across the arm
  EXPECT_EQ(robot.centres[0].frame, 1);
}

TEST(Urdf, CoupledJointsThroughOneAnother) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotTable robot = written_robot("two", kDescription);
  const JointVector q = (JointVector(2) << 0.3, -0.7).finished();
  std::vector<Pose> frames;
  forward(robot, q, frames);
  const Mat4 stand_from_a = shift(0, 0, 1) * rotation(2, 0.3) * rotation(1, 0.2) * rotation(0, 0.1);
  const Mat4 lower = stand_from_a * rotation(1, 0.3) * shift(0, 0, 0.4) * rotation(1, -0.7);
  const double d = -0.3 + 0.25, c = 2 * d + 0.5;
  EXPECT_LT((tip_pose(robot, frames, 0).matrix() -
             lower * shift(0, 0, 0.3) * rotation(0, c) * shift(0, 0, 0.1))
                .cwiseAbs()
                .maxCoeff(),
            1e-14);
  EXPECT_LT((frames[4].matrix() - lower * shift(0, 0, 0.1) * rotation(2, d)).cwiseAbs().maxCoeff(),
            1e-14);
}

TEST(Urdf, ShapesAreHeldByCapsulesAndSrdfAllowsPairs) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotTable robot = written_robot("two", kDescription);
  std::vector<std::string> names;
  for (const auto& capsule : robot.capsules) names.push_back(capsule.name);
  ASSERT_THAT(names, ElementsAre("stand", "upper", "ball"));
  EXPECT_EQ(robot.capsules[0].frame, -1);
  EXPECT_EQ((robot.capsules[0].to - robot.capsules[0].from).cwiseAbs(), Vec3(0, 0.4, 0));
  EXPECT_NEAR(robot.capsules[0].radius, 0.05 * std::sqrt(2), 1e-15);
  EXPECT_LT((robot.capsules[1].from - Vec3(0, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(robot.capsules[2].from, robot.capsules[2].to);
  EXPECT_TRUE(robot.capsules[2].may_touch_target);
  EXPECT_FALSE(robot.capsules[1].may_touch_target);
  using Pair = std::array<int, 2>;
  EXPECT_THAT(robot.allowed_pairs, ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}));
}

/// Whatever the shape, every point of it lies in one of the capsules that stand for it.
TEST(Urdf, NoPointOfAShapeIsOutsideItsCapsules) {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 size(number(0.005, 0.5), number(0.005, 0.5), number(0.005, 0.5));
    const bool box = i % 2 == 0;
    const std::string geometry =
        box ? fmt::format("<box size=\"{} {} {}\"/>", size.x(), size.y(), size.z())
            : fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", size.x(), size.z());
    std::string urdf = kUrdf;
    const std::string old = "<box size=\"0.1 0.4 0.1\"/>";
    urdf.replace(urdf.find(old), old.size(), geometry);
    write_text("two.urdf", urdf);
    write_text("two.srdf", kSrdf);
    const RobotTable robot = written_robot("two", kDescription);
    for (int k = 0; k < 100; ++k) {
      Vec3 point(number(-1, 1), number(-1, 1), number(-1, 1));
      point[k % 3] = point[k % 3] < 0 ? -1 : 1;  // on a face
      if (box) {
        point = 0.5 * point.cwiseProduct(size);
      } else {
        const double angle = number(0, 2 * std::numbers::pi);
        point = Vec3(size.x() * std::cos(angle), size.x() * std::sin(angle),
                     0.5 * size.z() * point.z());
      }
      double outside = 1;
      for (const RobotTable::Capsule& capsule : robot.capsules) {
        if (capsule.frame >= 0) continue;
        const Vec3 axis = capsule.to - capsule.from;
        const double t =
            axis.isZero(0)
                ? 0
                : std::clamp((point - capsule.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        outside = std::min(outside, (point - capsule.from - t * axis).norm() - capsule.radius);
      }
      ASSERT_LT(outside, 1e-12) << geometry;
    }
  }
}

TEST(Urdf, MeshesAreLeftOutOnlyIfOneSaysSo) {
  std::string urdf = kUrdf;
  const std::string old = "<sphere radius=\"0.06\"/>";
  urdf.replace(urdf.find(old), old.size(), "<mesh filename=\"package://x/y.stl\"/>");
  write_text("two.srdf", kSrdf);
  const std::filesystem::path file = write_text("two.urdf", urdf);
  std::string yaml = kDescription;
  yaml.erase(yaml.find("collision:"));
  try {
    written_robot("two", yaml);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ":28: link lower.collision: is a mesh"));
  }
  yaml.replace(yaml.find("  srdf"), 0, "  meshes: ignore\n");
  const RobotDescription description = load_robot(write_robot("two", yaml));
  EXPECT_EQ(description.table.capsules.size(), 2u);
  ASSERT_EQ(description.notes.size(), 1u);
  EXPECT_THAT(description.notes[0],
              HasSubstr("two.urdf:28: link lower.collision: a mesh, left out"));
}

TEST(Urdf, AHandFromAUrdfMountsOnAnArm) {
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
  const RobotTable robot = written_robot(
      "both", "name: both\nparts:\n  - {file: " + robot_file("pa10").string() +
                  "}\n  - {file: hand.yaml, parent: flange, mount: {position: [0, 0, 0.03]}}\n");
  const RobotTable shipped = shipped_robot("pa10_dlr_hit2");
  ASSERT_EQ(robot.joint_names, shipped.joint_names);
  std::mt19937 random(2);
  const JointVector q = random_position(robot, random);
  std::vector<Pose> ours, theirs;
  forward(robot, q, ours);
  forward(shipped, q, theirs);
  for (std::size_t tip = 0; tip < 2; ++tip) {
    EXPECT_LT((tip_pose(robot, ours, tip).matrix() - tip_pose(shipped, theirs, tip).matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
  }
  ASSERT_EQ(robot.centres.size(), 4u);  // elbow, wrist and the two fingers' middle joints
  EXPECT_EQ(robot.frames[static_cast<std::size_t>(robot.centres[3].frame)].name, "index_middle");
}

struct Fault {
  std::string what, from, to, message;
};
class UrdfError : public testing::TestWithParam<Fault> {};

TEST_P(UrdfError, NamesFileLineAndKey) {
  const Fault& fault = GetParam();
  std::string texts[] = {kUrdf, kSrdf, kDescription};
  const char* names[] = {"two.urdf", "two.srdf", "two.yaml"};
  std::string expected;
  for (int i = 2; i >= 0; --i) {
    const std::size_t at = expected.empty() ? texts[i].find(fault.from) : std::string::npos;
    if (at != std::string::npos) texts[i].replace(at, fault.from.size(), fault.to);
    if (at != std::string::npos) expected = "changed";
    write_text(names[i], texts[i]);
  }
  ASSERT_EQ(expected, "changed");
  try {
    load_robot(robot_folder() / "two.yaml");
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), (robot_folder() / fault.message).string());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, UrdfError,
    testing::Values(
        Fault{"missing_link", "<link name=\"tool\"/>", "",
              "two.urdf:18: joint plate.child: there is no link 'tool'"},
        Fault{"missing_parent", "<parent link=\"upper\"/>", "<parent link=\"uper\"/>",
              "two.urdf:22: joint b.parent: there is no link 'uper'"},
        Fault{"no_child", "<child link=\"upper\"/>", "", "two.urdf:6: joint a.child: is missing"},
        Fault{"loop", "<parent link=\"upper\"/>", "<parent link=\"tool\"/>",
              "two.urdf:16: joint plate: is part of a loop"},
        Fault{"two_parents", "<child link=\"other\"/>", "<child link=\"finger\"/>",
              "two.urdf:38: joint d.child: link 'finger' hangs on joint 'c' already"},
        Fault{"two_roots", "<link name=\"finger\"/>", "<link name=\"finger\"/><link name=\"far\"/>",
              "two.urdf:45: link far: hangs on nothing, as 'stand' does: there can be one root"},
        Fault{"zero_axis", "0 2 0", "0 0 0", "two.urdf:10: joint a.axis: must not be zero"},
        Fault{"crossed_limits", "lower=\"-1\"", "lower=\"1\"",
              "two.urdf:11: joint a.limit.upper: must be above lower"},
        Fault{"no_limits", "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"2\"/>", "",
              "two.urdf:6: joint a.limit: is missing"},
        Fault{"prismatic", "\"continuous\"", "\"prismatic\"",
              "two.urdf:21: joint b.type: must be revolute, continuous or fixed, not 'prismatic'"},
        Fault{"coupled_to_itself", "joint=\"a\" multiplier", "joint=\"c\" multiplier",
              "two.urdf:30: joint c.mimic: is coupled to itself"},
        Fault{"coupled_to_nothing", "joint=\"a\" multiplier", "joint=\"z\" multiplier",
              "two.urdf:30: joint c.mimic: there is no joint 'z' to copy"},
        Fault{"joint_twice", "joint name=\"b\"", "joint name=\"a\"",
              "two.urdf:21: joint a: stands twice"},
        Fault{"no_xml", "</robot>\n", "<robot>\n",
              "two.srdf:4: not valid XML: Error reading end tag."},
        Fault{"unknown_srdf_link", "link1=\"stand\"", "link1=\"stool\"",
              "two.srdf:2: disable_collisions.link1: there is no link 'stool'"},
        Fault{
            "no_jerk", "  jerk: 50\n", "",
            "two.yaml:3: urdf: joint 'a' needs an acceleration and a jerk above 0, for all joints "
            "or in limits"},
        Fault{"limits_of_nothing", "joint: b", "joint: c",
              "two.yaml:8: urdf.limits[0].joint: there is no actuated joint 'c'"},
        Fault{"tip_on_nothing", "frame: finger", "frame: fingre",
              "two.yaml:13: tips[0].frame: there is no frame or chain 'fingre'"},
        Fault{"tip_on_the_base", "frame: finger", "frame: stand",
              "two.yaml:13: tips[0].frame: a tip must move with a frame"},
        Fault{"chain_backwards", "first: a, last: tool", "first: tool, last: a",
              "two.yaml:10: chains[0].last: does not hang on first"}),
    [](const auto& instance) { return instance.param.what; });

TEST(UrdfErrors, TheUnchangedFilesLoad) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  EXPECT_EQ(written_robot("two", kDescription).joints(), 2u);
}

}  // namespace
}  // namespace morphe
