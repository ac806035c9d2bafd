#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "core/motion/input_error.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/generated_products.hpp"
#include "tests/core/robot/files/written_urdf.hpp"

namespace morphe::robot {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Urdf, JointsInTheFilesOrderBehindTheirParents) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotDescription description = load_robot(write_robot("two", kDescription));
  const RobotModel& robot = description.table;
  EXPECT_EQ(description.files.size(), 3u);
  EXPECT_THAT(robot.joint_names, ElementsAre("a", "b"));
  std::vector<std::string> frames;
  for (const auto& frame : robot.frames) frames.push_back(frame.name);
  EXPECT_THAT(frames, ElementsAre("stand", "a", "b", "tool", "c", "d"));
  EXPECT_THAT(std::vector(robot.upper.begin(), robot.upper.end()),
              ElementsAre(1, testing::DoubleNear(rad(90), 1e-15)));
  EXPECT_THAT(std::vector(robot.velocity.begin(), robot.velocity.end()),
              ElementsAre(1, 3));  // c turns twice as fast as a
  EXPECT_THAT(std::vector(robot.acceleration.begin(), robot.acceleration.end()),
              ElementsAre(2.5, 5));
  EXPECT_THAT(std::vector(robot.jerk.begin(), robot.jerk.end()), ElementsAre(25, 70));
  EXPECT_EQ(robot.shoulder_frame, 1);
  EXPECT_EQ(robot.palm_frame, 3);
  ASSERT_EQ(robot.joint_centres.size(), 1u);  // the elbow: both joints turn across the arm
  EXPECT_EQ(robot.joint_centres[0].frame, 2);
}

TEST(Urdf, CoupledJointsThroughOneAnother) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotModel robot = written_robot("two", kDescription);
  const JointVector q = (JointVector(2) << 0.3, -0.7).finished();
  std::vector<Pose> frames;
  forward_kinematics(robot, q, frames);
  const Mat4 stand_from_a = shift(0, 0, 1) * rotation(2, 0.3) * rotation(1, 0.2) * rotation(0, 0.1);
  const Mat4 lower = stand_from_a * rotation(1, 0.3) * shift(0, 0, 0.4) * rotation(1, -0.7);
  const double d = -0.3 + 0.25, c = 2 * d + 0.5;
  EXPECT_LT((tip_pose(robot, frames, 0).matrix() -
             lower * shift(0, 0, 0.3) * rotation(0, c) * shift(0, 0, 0.1))
                .cwiseAbs()
                .maxCoeff(),
            1e-14);
  EXPECT_LT((frames[5].matrix() - lower * shift(0, 0, 0.1) * rotation(2, d)).cwiseAbs().maxCoeff(),
            1e-14);
}

TEST(Urdf, ShapesAreHeldByCapsulesAndSrdfAllowsPairs) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotModel robot = written_robot("two", kDescription);
  std::vector<std::string> names;
  for (const auto& capsule : robot.capsules) names.push_back(capsule.name);
  ASSERT_THAT(names, ElementsAre("stand", "upper", "ball"));
  EXPECT_EQ(robot.capsules[0].frame, 0);
  EXPECT_EQ((robot.capsules[0].to - robot.capsules[0].from).cwiseAbs(), Vec3(0, 0.4, 0));
  EXPECT_NEAR(robot.capsules[0].radius, 0.05 * std::sqrt(2), 1e-15);
  EXPECT_LT((robot.capsules[1].from - Vec3(0, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(robot.capsules[2].from, robot.capsules[2].to);
  EXPECT_TRUE(robot.capsules[2].may_touch_target);
  EXPECT_FALSE(robot.capsules[1].may_touch_target);
  using Pair = std::array<int, 2>;
  EXPECT_THAT(robot.allowed_collision_pairs, ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}));
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
    const RobotModel robot = written_robot("two", kDescription);
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
      for (const RobotModel::Capsule& capsule : robot.capsules) {
        if (capsule.frame > 0) continue;
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

TEST(Urdf, MeshesAreLeftOutAndTheirLinksNamed) {
  std::string urdf = kUrdf;
  const std::string old = "<sphere radius=\"0.06\"/>";
  urdf.replace(urdf.find(old), old.size(), "<mesh filename=\"package://x/y.stl\"/>");
  write_text("two.srdf", kSrdf);
  write_text("two.urdf", urdf);
  std::string yaml = kDescription;
  yaml.erase(yaml.find("collision:"));
  const RobotDescription description = load_robot(write_robot("two", yaml));
  EXPECT_EQ(description.table.capsules.size(), 2u);
  EXPECT_THAT(description.notes, Contains(HasSubstr("two.urdf: meshes of lower are ignored")));
  EXPECT_THAT(description.table.unchecked_links, ElementsAre("lower", "finger"));
  // The finger has no shape at all, but a tip 10 cm from its joint.
  yaml +=
      "collision: {capsules: [{name: l, frame: lower, from: [0, 0, 0], to: [0, 0, 0.1], "
      "radius: 0.05}, {name: f, frame: finger, from: [0, 0, 0], to: [0, 0, 0.1], radius: 0.01}]}\n";
  EXPECT_THAT(written_robot("two", yaml).unchecked_links, IsEmpty());
}

TEST(Urdf, JointsAndLinksMayHaveAnyName) {
  std::string urdf = kUrdf;
  // A link called base, one called as another joint is, and names with dots and digits.
  for (const auto& [from, to] :
       {std::pair{"\"stand\"", "\"base\""}, std::pair{"\"tool\"", "\"b\""},
        std::pair{"\"upper\"", "\"0\""}, std::pair{"\"finger\"", "\"tip.0\""}}) {
    const std::string old = from;
    for (std::size_t at = urdf.find(old); at != std::string::npos; at = urdf.find(old))
      urdf.replace(at, old.size(), to);
  }
  write_text("two.urdf", urdf);
  const RobotModel robot = written_robot("two", R"(name: two
urdf: {file: two.urdf, velocity: 2, acceleration: 5, jerk: 50}
chains: [{name: arm, first: a, last: b}]
palm: base
tips: [{name: end, frame: tip.0, finger: index}]
collision: {capsules: [{name: c, frame: "0", from: [0, 0, 0], to: [0, 0, 1], radius: 0.1}]}
)");
  EXPECT_EQ(robot.frames[static_cast<std::size_t>(robot.palm_frame)].name, "base");
  EXPECT_THAT(robot.joint_names, ElementsAre("a", "b"));
  EXPECT_EQ(robot.frames[static_cast<std::size_t>(robot.capsules.back().frame)].name, "a");
}

std::string error_of(const std::string& yaml) {
  try {
    written_robot("two", yaml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Urdf, AllThatIsWrongIsToldAtOnce) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  std::string yaml = kDescription;
  yaml.replace(yaml.find("palm: tool"), 10, "palm: pool");
  yaml.replace(yaml.find("frame: finger"), 13, "frame: fingre");
  yaml.replace(yaml.find("[ball]"), 6, "[bell]");
  const std::string text = error_of(yaml);
  EXPECT_EQ(std::ranges::count(text, '\n'), 2) << text;
  for (const char* part : {"palm: there is no frame or link 'pool'", "'fingre'", "'bell'"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Urdf, SrdfPairsHoldForAllCapsulesOfALink) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", R"(<robot name="two">
  <disable_collisions link1="stand" link2="lower" reason="Never"/>
  <disable_collisions link1="camera" link2="lower" reason="Never"/>
</robot>)");
  std::string yaml = kDescription;
  yaml +=
      "  capsules: [{name: own, frame: lower, from: [0, 0, 0], to: [0, 0, 0.1], radius: 0.05}]\n";
  const RobotDescription description = load_robot(write_robot("two", yaml));
  using Pair = std::array<int, 2>;  // 0 stand, 1 upper, 2 ball, 3 own
  EXPECT_THAT(description.table.allowed_collision_pairs,
              ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{0, 3}, Pair{1, 2}, Pair{1, 3}, Pair{2, 3}));
  EXPECT_THAT(description.notes,
              Contains(HasSubstr("two.srdf:3: there is no link 'camera'; pair ignored")));
}

constexpr const char* kFinger = R"(<robot name="finger">
  <link name="palm"/><link name="proximal"/><link name="distal"/><link name="pad"/>
  <joint name="q1" type="revolute"><parent link="palm"/><child link="proximal"/>
    <axis xyz="0 1 0"/><limit lower="0" upper="2.0944" effort="1" velocity="8.07"/></joint>
  <joint name="q2" type="revolute"><parent link="proximal"/><child link="distal"/>
    <origin xyz="0 0 0.04"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="2.6586" effort="1" velocity="8.07"/>
    <mimic joint="q1" multiplier="1.0585" offset="0.7235"/></joint>
  <joint name="slide" type="prismatic"><parent link="distal"/><child link="pad"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="0.02" effort="1" velocity="0.2"/></joint>
</robot>)";
constexpr const char* kFingerYaml = R"(name: finger
urdf: {file: finger.urdf, acceleration: 30, jerk: 300}
chains: [{name: index, first: q1, last: slide}]
palm: palm
tips: [{name: tip, frame: pad, finger: index}]
)";

/// The Ability hand's finger: 16 degrees beyond its limit if the copy's own is forgotten.
TEST(Urdf, WhatACoupledJointMayDoLimitsItsDriver) {
  write_text("finger.urdf", kFinger);
  const RobotDescription finger = load_robot(write_robot("finger", kFingerYaml));
  const RobotModel& robot = finger.table;
  EXPECT_NEAR(robot.upper[0], (2.6586 - 0.7235) / 1.0585, 1e-12);
  EXPECT_NEAR(robot.upper[0], 1.828, 5e-4);
  EXPECT_EQ(robot.lower[0], 0);
  EXPECT_NEAR(robot.velocity[0], 8.07 / 1.0585, 1e-12);
  EXPECT_NEAR(robot.acceleration[0], 30 / 1.0585, 1e-12);
  ASSERT_EQ(robot.coupled_limits.size(), 1u);
  EXPECT_EQ(robot.coupled_limits[0].upper, 2.6586);
  EXPECT_THAT(finger.notes,
              Contains(HasSubstr("joint q1: q2, which is coupled to it, reduces its limits to "
                                 "[0, 1.828] from [0, 2.094]")));
  // Told to, a position limit of a copy is left out; its velocity is not.
  std::string yaml = kFingerYaml;
  yaml.replace(yaml.find("jerk: 300"), 9,
               "jerk: 300, limits: [{joint: q2, enforce_position_limits: false}]");
  const RobotModel free = written_robot("free", yaml);
  EXPECT_EQ(free.upper[0], 2.0944);
  EXPECT_NEAR(free.velocity[0], 8.07 / 1.0585, 1e-12);
}

TEST(Urdf, PrismaticJointsSlide) {
  write_text("finger.urdf", kFinger);
  const RobotModel robot = written_robot("finger", kFingerYaml);
  EXPECT_TRUE(robot.frames[3].prismatic);
  EXPECT_EQ(robot.upper[1], 0.02);
  std::vector<Pose> frames;
  forward_kinematics(robot, Eigen::Vector2d(-0.7235 / 1.0585, 0.015), frames);
  const Pose distal = frames[2];
  EXPECT_LT((tip_pose(robot, frames, 0).translation() - distal * Vec3(0, 0, 0.015)).norm(), 1e-15);
}

TEST(Urdf, JointsMayBeHeldAndThoseThatMoveNoTipAre) {
  write_text("finger.urdf", kFinger);
  std::string yaml = kFingerYaml;
  yaml += "fixed_joints: [{joint: slide, position: 0.01}]\n";
  const RobotModel held = written_robot("finger", yaml);
  EXPECT_THAT(held.joint_names, ElementsAre("q1"));
  std::vector<Pose> frames, free;
  forward_kinematics(held, JointVector::Constant(1, 0.5), frames);
  forward_kinematics(written_robot("free", kFingerYaml), Eigen::Vector2d(0.5, 0.01), free);
  EXPECT_LT((frames.back().matrix() - free.back().matrix()).cwiseAbs().maxCoeff(), 1e-15);

  yaml = kFingerYaml;
  yaml.replace(yaml.find("frame: pad"), 10, "frame: distal");
  const RobotDescription stopped = load_robot(write_robot("stopped", yaml));
  EXPECT_THAT(stopped.table.joint_names, ElementsAre("q1"));
  EXPECT_THAT(stopped.notes,
              Contains(HasSubstr("joints that move no fingertip are fixed: slide at 0")));
  yaml += "fixed_joints: [{joint: slide, position: 0.03}]\n";
  EXPECT_THAT(error_of(yaml), HasSubstr("0.03 is outside its limits, 0 to 0.02"));
}

TEST(Urdf, PartsOfOneTypeDifferByTheirPrefix) {
  write_text("finger.urdf", kFinger);
  write_robot("finger", kFingerYaml);
  const std::string pair =
      "parts:\n  - {file: finger.yaml, prefix: l_}\n"
      "  - {file: finger.yaml, prefix: r_, mount: {position: [1, 0, 0]}}\n"
      "palm: r_palm\n";
  const RobotModel robot = written_robot("pair", "name: pair\n" + pair);
  EXPECT_THAT(robot.joint_names, ElementsAre("l_q1", "l_slide", "r_q1", "r_slide"));
  EXPECT_EQ(robot.tips[1].name, "r_tip");
  EXPECT_EQ(robot.frames[static_cast<std::size_t>(robot.palm_frame)].name, "r_palm");
  std::string same = pair;
  same.replace(same.find(", prefix: r_"), 12, "");
  same.replace(same.find(", prefix: l_"), 12, "");
  EXPECT_THAT(error_of("name: pair\n" + same), HasSubstr("give this part a `prefix`"));
}

/// The curve of a Franka Research 3's first joint (libfranka): at its limit nothing is left.
TEST(Urdf, BrakingCurvesDrawPositionLimitsIn) {
  write_text("finger.urdf", kFinger);
  std::string yaml = kFingerYaml;
  yaml.replace(yaml.find("jerk: 300"), 9,
               "jerk: 300, limits: [{joint: q1, velocity: 2.62, braking: {twice_deceleration: 12, "
               "velocity_offset: 0.3, "
               "lower_end: -2.7501, upper_end: 1.7}}]");
  const RobotModel robot = written_robot("finger", yaml);
  ASSERT_EQ(robot.braking_curves.size(), 1u);
  const double left = 0.05 * robot.velocity[0];
  EXPECT_NEAR(std::sqrt(12 * (1.7 - robot.upper[0])) - 0.3, 0.05 * 2.62, 1e-2);
  EXPECT_LT(left, 0.05 * 2.63);
  EXPECT_EQ(robot.lower[0], 0);
}

TEST(Urdf, TooManyLinksAreRefused) {
  std::string urdf = "<robot name=\"long\"><link name=\"l0\"/>";
  for (int k = 1; k < 100000; ++k) {
    urdf += fmt::format(
        "<link name=\"l{1}\"/><joint name=\"j{1}\" type=\"fixed\"><parent "
        "link=\"l{0}\"/><child link=\"l{1}\"/></joint>",
        k - 1, k);
  }
  write_text("finger.urdf", urdf + "</robot>");
  EXPECT_THAT(error_of(kFingerYaml), HasSubstr("has 100000 links; at most 4096 are allowed"));
  std::string deep = "<robot name=\"deep\">";
  for (int k = 0; k < 100000; ++k) deep += "<link>";
  write_text("finger.urdf", deep);
  EXPECT_THAT(error_of(kFingerYaml), HasSubstr("not valid XML"));
}

}  // namespace
}  // namespace morphe::robot
