#include "stages/scene/other_arm.hpp"
#include "core/math/rotation.hpp"
#include "stages/scene/build_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace morphe::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two seconds of a left arm whose forearm turns about the elbow in a level plane; the wrist moves
/// along its bone as no real one does, so that its length changes by 10 mm from frame to frame.
struct LeftArm {
  HumanMotion motion;
  LeftArm() {
    constexpr std::size_t kFrames = 201;
    motion.tip = Array2D<Vec3>(kFrames, kFingerCount, unknown_point());
    for (std::size_t i = 0; i < kFrames; ++i) {
      motion.time.push_back(0.01 * static_cast<double>(i));
      motion.shoulder.emplace_back(-0.2, 0, 0.4);
      motion.elbow.emplace_back(-0.2, 0, 0.1);
      motion.wrist.push_back(motion.elbow[i] + (0.25 + shift(i)) * along(i));
      motion.wrist_orientation.push_back(unknown_rotation());
      motion.tip(i, kIndex) = motion.wrist[i] + 0.18 * along(i) + Vec3(0, 0, 0.02);
      motion.tip(i, kLittle) = motion.wrist[i] + 0.18 * along(i) - Vec3(0, 0, 0.02);
      motion.tip(i, kThumb) = motion.wrist[i] + Vec3(0, 0, 0.1);
    }
  }
  static double shift(std::size_t i) {
    const std::size_t third = i % 3;
    return third == 0 ? 0 : third == 1 ? 0.01 : -0.01;
  }
  Vec3 along(std::size_t i) const {
    return {std::sin(motion.time[i]), std::cos(motion.time[i]), 0};
  }
};

/// The two ends of a capsule's straight part at a time.
std::array<Vec3, 2> ends(const SceneObject& capsule, double time_s) {
  const Pose pose = recorded_pose(capsule, time_s);
  const double half = capsule.size[1] / 2;
  return {pose * Vec3(0, 0, -half), pose * Vec3(0, 0, half)};
}

std::vector<std::string> names(const std::vector<SceneObject>& objects) {
  std::vector<std::string> result;
  for (const SceneObject& object : objects) result.push_back(object.name);
  return result;
}

TEST(OtherArm, CapsulesLieAlongTheBonesWithOneLength) {
  const LeftArm arm;
  std::vector<std::string> notes;
  const auto capsules = other_arm_capsules({}, arm.motion, notes);
  ASSERT_THAT(names(capsules), ElementsAre("other upper arm", "other forearm", "other hand"));
  EXPECT_THAT(notes, IsEmpty());
  const SceneObject &upper_arm = capsules[0], &forearm = capsules[1], &hand = capsules[2];
  EXPECT_EQ(upper_arm.shape, Shape::capsule);
  EXPECT_NEAR(upper_arm.size[1], 0.3, 1e-12);
  EXPECT_NEAR(forearm.size[1], 0.25, 1e-12) << "the median";
  EXPECT_NEAR(hand.size[1], 0.18, 1e-12) << "to the middle of the fingers, without the thumb";
  for (std::size_t i = 0; i < arm.motion.time.size(); ++i) {
    const auto [elbow, wrist] = ends(forearm, arm.motion.time[i]);
    // Centred: of what the bone is longer by, half is at either end.
    EXPECT_LT((elbow - arm.motion.elbow[i] - LeftArm::shift(i) / 2 * arm.along(i)).norm(), 1e-12);
    EXPECT_LT((wrist - arm.motion.wrist[i] + LeftArm::shift(i) / 2 * arm.along(i)).norm(), 1e-12);
    EXPECT_LT((ends(hand, arm.motion.time[i])[0] - arm.motion.wrist[i]).norm(), 1e-12);
    EXPECT_LT((ends(upper_arm, arm.motion.time[i])[1] - arm.motion.elbow[i]).norm(), 1e-12);
    // It never turns about itself: a turn about the vertical and nothing else.
    if (i > 0) {
      EXPECT_NEAR(angle_between(forearm.orientation[i], forearm.orientation[i - 1]), 0.01, 1e-9);
    }
  }
}

TEST(OtherArm, GapsAreCrossedStraightAndSaid) {
  LeftArm arm;
  for (std::size_t i = 50; i < 90; ++i) arm.motion.wrist[i] = unknown_point();
  for (std::size_t i = 190; i < 201; ++i) arm.motion.elbow[i] = unknown_point();
  std::vector<std::string> notes;
  const auto capsules = other_arm_capsules({}, arm.motion, notes);
  ASSERT_EQ(capsules.size(), 3u);
  const SceneObject& forearm = capsules[1];
  for (const Vec3& position : forearm.position) EXPECT_TRUE(is_known(position));
  const Vec3 before = recorded_pose(forearm, 0.49).translation(),
             after = recorded_pose(forearm, 0.90).translation(),
             half = recorded_pose(forearm, 0.695).translation();
  EXPECT_LT((half - (before + after) / 2).norm(), 1e-9);
  EXPECT_EQ(recorded_pose(forearm, 2.0).translation(), forearm.position.back());
  EXPECT_NEAR(forearm.time.back(), 1.89, 1e-12);
  EXPECT_THAT(
      notes,
      ElementsAre(HasSubstr("other upper arm: not seen in 11 of 201 frames, for up to 0.11 s"),
                  HasSubstr("other forearm: not seen in 51 of 201 frames, for up to 0.41 s"),
                  HasSubstr("other hand: not seen in 40 of 201 frames")));
}

TEST(OtherArm, AHandWithoutFingersGoesOnFromItsWrist) {
  LeftArm arm;
  arm.motion.tip = Array2D<Vec3>(201, kFingerCount, unknown_point());
  const Quat down = math::shortest_rotation(Vec3::UnitZ(), -Vec3::UnitZ());
  for (std::size_t i = 0; i < 100; ++i) arm.motion.wrist_orientation[i] = down;
  std::vector<std::string> notes;
  const auto capsules = other_arm_capsules({}, arm.motion, notes);
  ASSERT_EQ(capsules.size(), 3u);
  const double length = 0.25 * 0.108 / 0.146;
  EXPECT_NEAR(capsules[2].size[1], length, 1e-9);
  EXPECT_LT((ends(capsules[2], 0.5)[1] - arm.motion.wrist[50] + Vec3(0, 0, length)).norm(), 1e-9);
  EXPECT_LT((ends(capsules[2], 1.5)[1] - arm.motion.wrist[150] - length * arm.along(150)).norm(),
            1e-9);
  EXPECT_THAT(
      notes, ElementsAre(HasSubstr("no fingertip seen in 100 of 201 frames: there the hand is "
                                   "placed along the hand's orientation"),
                         HasSubstr("in 101 of 201 frames: there the hand is placed in line with")));
}

TEST(OtherArm, WhatIsMissingOrEstimatedIsSaid) {
  LeftArm arm;
  std::vector<std::string> notes;
  arm.motion.shoulder.assign(201, unknown_point());
  EXPECT_THAT(names(other_arm_capsules({}, arm.motion, notes)),
              ElementsAre("other forearm", "other hand"));
  EXPECT_THAT(notes, ElementsAre("other upper arm was not recorded: it is not an obstacle"));

  notes.clear();
  LeftArm guessed;
  guessed.motion.estimated = {"shoulder", "elbow", "fingertips"};
  EXPECT_EQ(other_arm_capsules({}, guessed.motion, notes).size(), 3u);
  EXPECT_THAT(notes,
              ElementsAre("the person's other arm: shoulder and elbow not recorded: estimated"));

  for (const HumanMotion& nothing : {HumanMotion{}, [] {
                                       HumanMotion hidden = LeftArm().motion;
                                       hidden.shoulder = hidden.elbow = hidden.wrist =
                                           std::vector<Vec3>(201, unknown_point());
                                       return hidden;
                                     }()}) {
    notes.clear();
    EXPECT_THAT(other_arm_capsules({}, nothing, notes), IsEmpty());
    EXPECT_THAT(notes,
                ElementsAre("the person's other arm was not recorded: it is not an obstacle"));
  }

  notes.clear();
  LeftArm torn;
  torn.motion.wrist[70] += 0.3 * torn.along(70);
  other_arm_capsules({}, torn.motion, notes);
  EXPECT_THAT(notes,
              testing::Contains(HasSubstr(
                  "other forearm: 250 mm long, but its joints are 560 mm apart in a frame")));
}

TEST(OtherArm, IsNeverWhatIsGrasped) {
  // The other hand lies at the very fingertips that close: the cup is inferred between them all the
  // same. Without the key an object of that name is one as any other.
  HumanMotion motion;
  Movement movement;
  motion.tip = Array2D<Vec3>(101, kFingerCount, unknown_point());
  for (std::size_t i = 0; i < 101; ++i) {
    motion.time.push_back(0.01 * static_cast<double>(i));
    motion.tip(i, kThumb) = Vec3(0.15, 0.3, 0.1);
    motion.tip(i, kIndex) = Vec3(0.24, 0.3, 0.1);
  }
  movement.end_s = 1;
  movement.phases = {{PhaseKind::reach, 0, 0.5}, {PhaseKind::grasp, 0.5, 1}};
  SceneObject hand;
  hand.name = "other hand";
  hand.shape = Shape::capsule;
  hand.size = {0.045, 0.18};
  hand.time = {0};
  hand.position = {Vec3(0.2, 0.3, 0.1)};
  hand.orientation = {Quat::Identity()};
  Demonstration demonstration;
  demonstration.objects = {hand};
  SceneOptions options;
  build_scene(options, demonstration, motion, movement);
  EXPECT_EQ(movement.target, "other hand");
  movement.target.clear();
  options.other_arm = true;
  const Scene with = build_scene(options, demonstration, motion, movement);
  EXPECT_EQ(movement.target, "cup");
  const Scene without = build_scene(options, {}, motion, movement);
  for (const char* name : {"table", "cup"}) {
    const SceneObject *one = find_object(with.objects, name),
                      *other = find_object(without.objects, name);
    ASSERT_TRUE(one && other);
    EXPECT_EQ(one->size, other->size);
    EXPECT_EQ(one->position, other->position);
  }
  EXPECT_THAT(mapping_obstacles(options, with), ElementsAre("table"));
}

TEST(OtherArm, ItsKeysAreChecked) {
  SceneOptions options;
  options.other_arm_radii = {0.05, 0.05};
  EXPECT_THAT(validation_error(options), HasSubstr("other_arm_radii: needs three radii"));
  options = {};
  ConfiguredObject object;
  object.name = "other hand";
  options.objects = {object};
  EXPECT_EQ(validation_error(options), "");
  options.other_arm = true;
  EXPECT_EQ(validation_error(options), "objects: the name 'other hand' is already used");
  options.objects.clear();
  options.target.name = "other forearm";
  EXPECT_THAT(validation_error(options), HasSubstr("is used by the other arm"));
}

}  // namespace
}  // namespace morphe::scene
