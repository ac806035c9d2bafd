// What setup derives, against robots whose answers are known: the shipped ones, written as URDFs
// that say nothing but joints and shapes, and arms whose axes meet where they were put.
#include "pipeline/setup/setup.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <numbers>
#include <regex>

#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/write_urdf.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/merge_sections.hpp"
#include "tests/core/robot/files/written_urdf.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::setup {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

fs::path folder() { return robot::robot_folder(); }

/// A shipped robot as a URDF, its tips and fixed frames left out, joints and links called j1, l1, …
fs::path nameless(const std::string& name) {
  RobotModel table = robot::shipped_robot(name);
  table.tips.clear();
  std::string text = robot::urdf_of(table);
  int number = 0;
  for (const RobotModel::Frame& frame : table.frames) {
    const std::string plain = fmt::format("n{}", ++number);
    text = std::regex_replace(text, std::regex("\"" + frame.name + "\""), "\"" + plain + "\"");
  }
  return robot::write_text(name + ".urdf", text);
}

robot::RobotDescription set_up_file(const fs::path& urdf, SetupResult* result = nullptr) {
  SetupRequest request;
  request.urdf = urdf;
  request.out = folder() / "out.yaml";
  const SetupResult made = make_description(request, std::nullopt);
  if (result) *result = made;
  return robot::parse_robot(made.text, request.out);
}

std::vector<Pose> poses_at_zero(const RobotModel& table) {
  std::vector<Pose> poses;
  robot::forward_kinematics(
      table, JointVector::Zero(table.lower.size()).cwiseMax(table.lower).cwiseMin(table.upper),
      poses);
  return poses;
}

Vec3 frame_at(const RobotModel& table, int frame) {
  return poses_at_zero(table)[static_cast<std::size_t>(frame)].translation();
}

TEST(SetUp, TheCentresOfAnArmLieWhereItsAxesMeet) {
  const RobotModel pa10 = robot::shipped_robot("pa10");
  const RobotModel found = set_up_file(nameless("pa10")).table;
  EXPECT_EQ(found.joints(), 7u);
  EXPECT_LT((frame_at(found, found.shoulder_frame) - Vec3(0, 0, 0.317)).norm(), 1e-6);
  ASSERT_EQ(found.joint_centres.size(), 1u);  // an arm alone: its wrist is the end-effector
  EXPECT_LT((frame_at(found, found.joint_centres[0].frame) - Vec3(0, 0, 0.317 + 0.45)).norm(),
            1e-6);
  // The flange: z outwards, along the last axis.
  const Pose flange = robot::tip_pose(found, poses_at_zero(found), 0);
  EXPECT_LT((flange.linear().col(2) - Vec3::UnitZ()).norm(), 1e-6);
  EXPECT_EQ(found.velocity, pa10.velocity);
}

TEST(SetUp, AHandIsKnownByItsGeometryAlone) {
  const RobotModel hand = robot::shipped_robot("dlr_hit2");
  SetupResult result;
  const robot::RobotDescription description = set_up_file(nameless("dlr_hit2"), &result);
  const RobotModel& found = description.table;
  ASSERT_EQ(found.tips.size(), 5u);
  const std::vector<Pose> ours = poses_at_zero(found), theirs = poses_at_zero(hand);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(found.tips[i].finger, static_cast<int>(i));
    // Capsules of 11 mm end 26.6 mm from the last joint: the pad lies 11 mm above the bone.
    const Pose tip = robot::tip_pose(found, ours, i);
    const Pose bone = theirs[robot::frame_named(hand, fmt::format("{}_distal", kFingerNames[i]))];
    const Vec3 in_bone = bone.inverse() * tip.translation();
    EXPECT_NEAR(in_bone.x(), 0.0266 - 0.008, 1e-3) << i;
    EXPECT_NEAR(in_bone.z(), 0, 2e-3) << i;
    EXPECT_NEAR(std::abs(in_bone.y()), 0.001, 1.5e-3) << i;  // pad_depth is 10 mm of 11
    EXPECT_LT((tip.linear().col(2) - bone.linear().col(0)).norm(), 0.02) << i;
  }
  // The palm: z to the fingers, x out of it, as the shipped description has them.
  const Pose palm = ours[static_cast<std::size_t>(found.palm_frame)];
  EXPECT_GT(palm.linear().col(2).z(), 0.98);
  EXPECT_GT(palm.linear().col(0).x(), 0.98);
  EXPECT_EQ(description.table.side, Side::right);
  EXPECT_THAT(result.to_check, Contains(HasSubstr("a right hand")));
  // Middle joints, and postures that follow the index.
  ASSERT_EQ(found.joint_centres.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto wanted = robot::frame_named(hand, fmt::format("{}_middle", kFingerNames[i]));
    EXPECT_LT((frame_at(found, found.joint_centres[i].frame) - theirs[wanted].translation()).norm(),
              1e-9);
  }
  EXPECT_EQ(description.natural.size(), 9u);
  EXPECT_TRUE(found.unchecked_links.empty());
}

TEST(SetUp, AFingerMayEndBeyondItsShapes) {
  RobotModel hand = robot::shipped_robot("dlr_hit2");
  for (RobotModel::Capsule& capsule : hand.capsules) {
    if (capsule.name == "index_distal") capsule.to = capsule.from;  // 14 mm before the tip
    if (capsule.name == "ring_distal") capsule.to.x() -= 0.009;     // 7.4 mm
  }
  SetupResult result;
  const RobotModel found =
      set_up_file(robot::write_text("bracket.urdf", robot::urdf_of(hand)), &result).table;
  const std::vector<Pose> ours = poses_at_zero(found), theirs = poses_at_zero(hand);
  const auto along_bone = [&](const char* finger) {
    for (std::size_t i = 0; i < found.tips.size(); ++i) {
      if (kFingerNames[static_cast<std::size_t>(found.tips[i].finger)] != std::string(finger))
        continue;
      const auto bone = robot::frame_named(hand, fmt::format("{}_distal", finger));
      return (theirs[bone].inverse() * robot::tip_pose(found, ours, i).translation()).x();
    }
    return kUnknown;
  };
  // The file's tips lie 25 mm from the last joints. The ring's shapes are near enough to be right.
  EXPECT_NEAR(along_bone("index"), 0.025, 1e-6);
  EXPECT_NEAR(along_bone("ring"), 0.0266 - 0.009 - 0.008, 3e-3);  // a round end
  EXPECT_THAT(result.to_check, Contains(HasSubstr("shapes of index_distal end before")));
  // What the shapes leave out is held by a capsule to the tip.
  double reaches_m = 0;
  for (const RobotModel::Capsule& capsule : found.capsules) {
    if (found.frames[static_cast<std::size_t>(capsule.frame)].name != "index_distal") continue;
    reaches_m = std::max(reaches_m, std::max(capsule.from.x(), capsule.to.x()) + capsule.radius);
  }
  EXPECT_NEAR(reaches_m, 0.025, 3e-3);
}

TEST(SetUp, TheMirrorOfAHandIsALeftOne) {
  RobotModel hand = robot::shipped_robot("dlr_hit2");
  const Eigen::DiagonalMatrix<double, 3> mirror(1, -1, 1);
  const auto reflect = [&](Vec3& v) { v.y() = -v.y(); };
  for (auto& frame : hand.frames) {
    frame.transform.linear() = mirror * frame.transform.linear() * mirror;
    frame.transform.translation().y() *= -1;
    frame.axis = -(mirror * frame.axis);
  }
  for (auto& capsule : hand.capsules) {
    reflect(capsule.from);
    reflect(capsule.to);
  }
  hand.tips.clear();
  const robot::RobotDescription found =
      set_up_file(robot::write_text("left.urdf", robot::urdf_of(hand)));
  EXPECT_EQ(found.table.side, Side::left);
  EXPECT_EQ(found.table.tips.size(), 5u);
}

/// Seven joints whose first three axes meet at 0.4 m but stand elsewhere on them, an elbow 50 mm
/// off, and a last axis that passes the wrist by 76 mm; all frames lie at random along their axes.
std::string skew_arm() {
  struct Joint {
    Vec3 origin, axis;  // in the base frame, stretched upwards
  };
  const std::vector<Joint> joints = {{{0, 0, 0.1}, {0, 0, 1}},     {{0, 0.2, 0.4}, {0, 1, 0}},
                                     {{0, 0, 0.7}, {0, 0, 1}},     {{0.05, -0.1, 0.8}, {0, 1, 0}},
                                     {{0, 0, 0.9}, {0, 0, 1}},     {{0, 0.1, 1.2}, {0, 1, 0}},
                                     {{0.076, 0, 1.25}, {0, 0, 1}}};
  std::string text = "<robot name=\"skew\"><link name=\"base\"/>";
  Vec3 before = Vec3::Zero();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const Vec3 step = joints[k].origin - before;
    text += fmt::format(
        "<link name=\"l{0}\"><collision><geometry><sphere radius=\"0.05\"/></geometry></collision>"
        "</link><joint name=\"j{0}\" type=\"revolute\"><parent link=\"{1}\"/><child link=\"l{0}\"/>"
        "<origin xyz=\"{2} {3} {4}\"/><axis xyz=\"{5} {6} {7}\"/><limit lower=\"-2\" upper=\"2\" "
        "effort=\"0\" velocity=\"2\"/></joint>",
        k, k == 0 ? "base" : fmt::format("l{}", k - 1), step.x(), step.y(), step.z(),
        joints[k].axis.x(), joints[k].axis.y(), joints[k].axis.z());
    before = joints[k].origin;
  }
  return text + "</robot>";
}

TEST(SetUp, CentresDoNotDependOnWhereFramesStandAlongTheirAxes) {
  SetupResult result;
  const RobotModel arm = set_up_file(robot::write_text("skew.urdf", skew_arm()), &result).table;
  EXPECT_LT((frame_at(arm, arm.shoulder_frame) - Vec3(0, 0, 0.4)).norm(), 1e-9);
  EXPECT_LT((frame_at(arm, arm.joint_centres[0].frame) - Vec3(0.05, 0, 0.8)).norm(), 1e-9);
  EXPECT_THAT(result.text, HasSubstr("wrist_centre, parent: l4"));
  const auto wrist = robot::frame_named(arm, "wrist_centre");
  EXPECT_LT((frame_at(arm, static_cast<int>(wrist)) - Vec3(0, 0, 1.2)).norm(), 1e-9);
  // Nothing publishes limits for it: 3 v and 50 a, and that is said.
  EXPECT_EQ(arm.acceleration[0], 6);
  EXPECT_EQ(arm.jerk[0], 300);
  EXPECT_THAT(result.to_check, Contains("acceleration and jerk of 7 joints are assumed"));
}

TEST(SetUp, PublishedLimitsAreTaken) {
  std::string text = std::regex_replace(skew_arm(), std::regex("\"skew\""), "\"fr3\"");
  const RobotModel arm = set_up_file(robot::write_text("fr3.urdf", text)).table;
  ASSERT_EQ(arm.braking_curves.size(), 7u);
  EXPECT_EQ(arm.acceleration[0], 10);
  EXPECT_EQ(arm.jerk[6], 5000);
  EXPECT_EQ(arm.braking_curves[1].twice_deceleration, 5.17);
}

TEST(SetUp, WhatAPersonChangedStays) {
  SetupRequest request;
  request.urdf = nameless("dlr_hit2");
  request.out = folder() / "out.yaml";
  const std::string first = make_description(request, std::nullopt).text;
  EXPECT_EQ(make_description(request, first).text, first);
  std::string changed = first;
  const std::size_t at = changed.find("pad_depth: 0.01");
  changed.replace(at, 15, "pad_depth: 0.02");
  request.name = "renamed";
  const SetupResult again = make_description(request, changed);
  EXPECT_THAT(again.text, HasSubstr("pad_depth: 0.02"));
  EXPECT_THAT(again.text, HasSubstr("name: renamed"));
  EXPECT_THAT(again.notes, Contains("kept because edited: tips"));
}

TEST(SetUp, AHandIsMountedOnAFlange) {
  for (const char* name : {"pa10", "dlr_hit2"}) {
    SetupRequest request;
    request.urdf = nameless(name);
    request.out = folder() / (std::string(name) + ".yaml");
    robot::write_text(std::string(name) + ".yaml", make_description(request, std::nullopt).text);
  }
  MountRequest request{folder() / "pa10.yaml", folder() / "dlr_hit2.yaml", folder() / "both.yaml",
                       "", HandMount{{0, 0, 0.03}, {0, 0, 0}}};
  const robot::RobotDescription both =
      robot::parse_robot(mount_hand(request, std::nullopt).text, request.out);
  const RobotModel shipped = robot::shipped_robot("pa10_dlr_hit2");
  EXPECT_EQ(both.table.joints(), shipped.joints());
  const std::vector<Pose> ours = poses_at_zero(both.table), theirs = poses_at_zero(shipped);
  const Vec3 tip = robot::tip_pose(both.table, ours, 1).translation();
  // The shipped tip lies on the bone, 25 mm from the last joint; ours 18.6 mm, above it.
  EXPECT_LT((tip - robot::tip_pose(shipped, theirs, 1).translation()).norm(), 0.01);
  EXPECT_EQ(both.table.joint_centres.size(), 7u);  // elbow, wrist, five fingers
  // In the wrist, and turned back through it.
  request.mount = HandMount{{0, 0, -0.15}, {0, 0, 0}};
  const auto mount = [&] { (void)mount_hand(request, std::nullopt); };
  EXPECT_THAT(mount, testing::ThrowsMessage<InputError>(HasSubstr("move it outwards: --mount")));
  request.mount = HandMount{{0, 0, 0}, {0, std::numbers::pi, 0}};
  EXPECT_THAT(mount, testing::ThrowsMessage<InputError>(HasSubstr("point back along the arm")));
  // Without a mount the fingers point along the flange's axis.
  request.mount.reset();
  const SetupResult assumed = mount_hand(request, std::nullopt);
  EXPECT_THAT(assumed.to_check, Contains(HasSubstr("mount of the hand: assumed")));
}

TEST(SetUp, AnArmAndItsHandMayComeInOneFile) {
  const robot::RobotDescription both = set_up_file(nameless("pa10_dlr_hit2"));
  EXPECT_EQ(both.table.joints(), 22u);
  EXPECT_EQ(both.table.tips.size(), 5u);
  EXPECT_EQ(both.table.joint_centres.size(), 7u);
  // The same again, of the URDF that is written of it: its frames have the names that setup gives.
  const RobotModel table = both.table;
  const robot::RobotDescription twice =
      set_up_file(robot::write_text("twice.urdf", robot::urdf_of(table)));
  EXPECT_EQ(twice.table.joints(), 22u);
  EXPECT_LT((frame_at(twice.table, twice.table.shoulder_frame) - Vec3(0, 0, 0.317)).norm(), 1e-6);
}

TEST(SetUp, SaysWhatIsWrong) {
  SetupRequest request;
  request.urdf = robot::write_text("arm.urdf", skew_arm());
  request.out = folder() / "out.yaml";
  request.hand = "nowhere";
  EXPECT_THAT([&] { make_description(request, std::nullopt); },
              testing::ThrowsMessage<InputError>(HasSubstr("link 'nowhere' does not exist")));
  request.hand.clear();
  std::string text = skew_arm();
  text.replace(text.find("<sphere radius=\"0.05\"/>"), 23,
               "<mesh filename=\"package://x/y.stl\"/>");
  request.urdf = robot::write_text("mesh.urdf", text);
  EXPECT_THAT(make_description(request, std::nullopt).notes,
              Contains(HasSubstr("a mesh was not found, so the link has no shape: "
                                 "'package://x/y.stl'")));
}

TEST(KeepChanges, SectionsThatNobodyTouchedAreMadeAnew) {
  const std::vector<Section> old = {{"a", "one: 1\n"}, {"b", "two: 2\n"}};
  const std::vector<Section> now = {{"a", "one: 10\n"}, {"b", "two: 20\n"}, {"c", "three: 3\n"}};
  std::string text = join_sections(old);
  text.replace(text.find("two: 2"), 6, "two: 7");
  std::vector<std::string> kept;
  const std::string after = merge_sections(now, text, kept);
  EXPECT_THAT(kept, ElementsAre("b"));
  EXPECT_THAT(after, HasSubstr("one: 10\n"));
  EXPECT_THAT(after, HasSubstr("two: 7\n"));
  EXPECT_THAT(after, HasSubstr("three: 3\n"));
  EXPECT_THAT(after, Not(HasSubstr("two: 20")));
  kept.clear();
  EXPECT_EQ(merge_sections(now, after, kept), after);  // and still counts as changed
  EXPECT_THAT(kept, ElementsAre("b"));
}

}  // namespace
}  // namespace morphe::setup
