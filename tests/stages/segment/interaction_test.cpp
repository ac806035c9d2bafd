#include "stages/segment/interaction.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "stages/segment/segment.hpp"
#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Strokes = std::vector<SyntheticHand::Stroke>;

/// Where drinking_hand() has its object: between thumb and index tip as they arrive, 0.11 apart.
const Vec3 kAtGrasp(0.26 - 0.055, 0.35, 0.08);
const Vec3 kLift(-0.1, -0.25, 0.4);

/// A ball of 5 cm radius, which fills the closed hand, along minimum-jerk strokes; 50 Hz.
SceneObject ball(const std::string& name, const Vec3& start, const Strokes& strokes,
                 double radius = 0.05) {
  SceneObject object;
  object.name = name;
  object.shape = Shape::sphere;
  object.size = {radius};
  for (int i = 0; i <= 250; ++i) {
    const double t = 0.02 * i;
    Vec3 at = start;
    for (const auto& s : strokes)
      at += SyntheticHand::progress((t - s.begin_s) / s.length_s) * s.by;
    object.time.push_back(t);
    object.position.push_back(at);
    object.orientation.push_back(Quat::Identity());
  }
  return object;
}

/// The opening does not tell.
SyntheticHand still_fingers() {
  SyntheticHand hand = drinking_hand();
  hand.opening = {{0, 0.11}};
  return hand;
}

std::vector<ObjectMotion> motions_of(const SyntheticHand& hand,
                                     const std::vector<SceneObject>& objects) {
  const HumanMotion motion = hand.motion();
  const HandSignals signals = hand_signals(motion, SegmentOptions{}.velocity_smoothing_s);
  return motions_by_hand(object_motions(objects, 0.005),
                         find_interactions(motion, signals, objects), signals);
}

TEST(Contact, TellsHowFarTheHandIsAndWhatItHolds) {
  const SyntheticHand hand = still_fingers();
  HumanMotion motion = hand.motion();
  const HandSignals signals = hand_signals(motion, 0.02);
  const SceneObject object = ball("ball", kAtGrasp, {{1.9, 0.9, kLift}});
  const HandObjectInteraction contact = find_interactions(motion, signals, {object}).front();
  EXPECT_NEAR(contact.distance[0], std::hypot(0.2, 0.01), 1e-9);  // of the index tip
  EXPECT_NEAR(contact.distance[175], 0.005, 1e-9);
  EXPECT_FALSE(contact.between_tips[0]);
  EXPECT_TRUE(contact.between_tips[175]);
  EXPECT_TRUE(contact.moves_with_hand[230]);
  EXPECT_FALSE(contact.moves_with_hand[100]);
  EXPECT_FALSE(contact.moves_with_hand[370]);  // the hand goes home, the ball stays
  // Without fingertips the wrist tells, if less well.
  for (Vec3& tip : motion.tip.values) tip = unknown_point();
  const HandObjectInteraction by_wrist =
      find_interactions(motion, hand_signals(motion, 0.02), {object}).front();
  EXPECT_LT(by_wrist.distance[175], 0.03);
  EXPECT_TRUE(by_wrist.moves_with_hand[230]);
}

TEST(Contact, AWideBodyBetweenTheTipsIsNotHeld) {
  const SyntheticHand hand = still_fingers();
  const HumanMotion motion = hand.motion();
  const HandSignals signals = hand_signals(motion, 0.02);
  SceneObject table;
  table.name = "table";
  table.size = {1, 1, 0.04};
  table.time = {0};
  table.position = {kAtGrasp - Vec3(0, 0, 0.015)};  // its top 5 mm above the tips
  table.orientation = {Quat::Identity()};
  SceneObject pin = table;  // in the open hand, which does not touch it
  pin.name = "pin";
  pin.size = {0.01, 0.01, 0.1};
  for (const HandObjectInteraction& contact : find_interactions(motion, signals, {table, pin})) {
    EXPECT_FALSE(contact.between_tips[175]) << contact.object;
    EXPECT_EQ(longest_held_object({contact}, signals, 1.6, 1.9, 0.06), "");
  }
}

TEST(Contact, WhatTheOtherHandMovesIsNoEvidence) {
  // Beside it, along the same way at the same time, 0.4 m to the left: the other hand's.
  const SceneObject others = ball("others", kAtGrasp - Vec3(0.4, 0, 0), {{1.9, 0.9, kLift}});
  EXPECT_THAT(motions_of(still_fingers(), {others}), IsEmpty());
  const auto movements = segment(still_fingers().motion(), {}, {others});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "");
  EXPECT_EQ(kinds(movements[0]).front(), PhaseKind::reach);
  EXPECT_THAT(kinds(movements[0]), testing::Not(testing::Contains(PhaseKind::grasp)));
}

/// While this hand reaches, waits and carries, the other one moves things of its own: the phases
/// are those of the recording without them.
TEST(Contact, ThePhasesAreThoseOfThisHandWhateverElseMoves) {
  const SceneObject mine = ball("mine", kAtGrasp, {{1.9, 0.9, kLift}});
  const auto alone = segment(still_fingers().motion(), {}, {mine});
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].target, "mine");
  EXPECT_THAT(kinds(alone[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  for (double begin_s = 0; begin_s < 4; begin_s += 0.17) {
    const SceneObject others =
        ball("others", kAtGrasp + Vec3(-0.35, 0.05, 0), {{begin_s, 0.7, Vec3(0.05, -0.2, 0.3)}});
    for (const std::vector<SceneObject>& objects :
         {std::vector{others, mine}, std::vector{mine, others}}) {
      const auto movements = segment(still_fingers().motion(), {}, objects);
      ASSERT_EQ(movements.size(), 1u) << begin_s;
      EXPECT_EQ(movements[0].target, "mine") << begin_s;
      ASSERT_EQ(kinds(movements[0]), kinds(alone[0])) << begin_s;
      for (std::size_t k = 0; k < alone[0].phases.size(); ++k) {
        EXPECT_NEAR(movements[0].phases[k].begin_s, alone[0].phases[k].begin_s, 1e-9);
        EXPECT_NEAR(movements[0].phases[k].end_s, alone[0].phases[k].end_s, 1e-9);
      }
    }
  }
}

/// The other hand brings the ball and holds it out; this one takes it, carries it, and the other
/// takes it away again while this hand goes home.
TEST(Contact, AHandoverIsAGraspAndARelease) {
  const SceneObject given =
      ball("given", kAtGrasp - Vec3(0.3, 0, 0.1),
           {{0.4, 1.0, Vec3(0.3, 0, 0.1)}, {1.9, 0.9, kLift}, {3.1, 0.9, Vec3(-0.4, 0.1, -0.1)}});
  const auto motions = motions_of(still_fingers(), {given});
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_NEAR(motions[0].begin_s, 1.95, 0.1);
  EXPECT_NEAR(motions[0].end_s, 2.75, 0.1);
  const auto movements = segment(still_fingers().motion(), {}, {given});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "given");
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  EXPECT_NEAR(movements[0].phases[3].begin_s, 1.9, 0.1);
  EXPECT_NEAR(movements[0].phases[5].begin_s, 3.2, 0.1);
}

/// Handed over in motion: the ball never rests between the two hands.
TEST(Contact, AHandoverInMotionBeginsWhereTheBallGoesWithTheHand) {
  const SceneObject given = ball("given", kAtGrasp - Vec3(0.3, 0.1, 0.1),
                                 {{0.9, 1.1, Vec3(0.3, 0.1, 0.1)}, {1.9, 0.9, kLift}});
  const auto motions = motions_of(still_fingers(), {given});
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_GT(motions[0].begin_s, 1.6);
  EXPECT_LT(motions[0].begin_s, 2.2);
  const auto movements = segment(still_fingers().motion(), {}, {given});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "given");
}

TEST(Contact, OfATrayAndItsCupTheOneAtTheFingertipsIsTaken) {
  const SceneObject tray = ball("tray", kAtGrasp, {{1.9, 0.9, kLift}});
  const SceneObject cup = ball("cup", kAtGrasp + Vec3(-0.08, 0.1, 0.06), {{1.9, 0.9, kLift}}, 0.02);
  for (const std::vector<SceneObject>& objects : {std::vector{cup, tray}, std::vector{tray, cup}}) {
    const auto movements = segment(still_fingers().motion(), {}, objects);
    ASSERT_EQ(movements.size(), 1u);
    EXPECT_EQ(movements[0].target, "tray");
  }
}

/// A ball that the hand knocks away as it arrives is not what it carries.
TEST(Contact, WhatIsPushedAsideIsNotTheTarget) {
  const SceneObject mine = ball("mine", kAtGrasp, {{1.9, 0.9, kLift}});
  const SceneObject pushed =
      ball("pushed", kAtGrasp + Vec3(0.13, 0, 0), {{1.3, 0.4, Vec3(0.2, 0, 0)}});
  const auto movements = segment(still_fingers().motion(), {}, {pushed, mine});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "mine");
}

/// A handle that stays where it is: neither object nor opening moves, but the tips hold it.
TEST(Contact, WhatTheTipsHoldIsGraspedThoughNothingMoves) {
  SyntheticHand hand = still_fingers();
  hand.strokes = {{0.8, 0.9, Vec3(0.06, 0.25, 0.06)}, {2.5, 0.9, Vec3(-0.06, -0.25, -0.06)}};
  const SceneObject handle = ball("handle", kAtGrasp, {});
  const SceneObject beside = ball("beside", kAtGrasp + Vec3(0, 0.12, 0), {});
  const auto movements = segment(hand.motion(), {}, {beside, handle});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "handle");
  EXPECT_THAT(kinds(movements[0]), ElementsAre(PhaseKind::reach, PhaseKind::preshape,
                                               PhaseKind::grasp, PhaseKind::return_phase));
  // With the ball beside it alone the hand touches nothing.
  const auto touch = segment(hand.motion(), {}, {beside});
  ASSERT_EQ(touch.size(), 1u);
  EXPECT_THAT(kinds(touch[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::hold, PhaseKind::return_phase));
}

}  // namespace
}  // namespace morphe::segment
