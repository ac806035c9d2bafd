#include "stages/segment/segment.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Phase& phase(const Movement& movement, PhaseKind kind) {
  for (const Phase& p : movement.phases) {
    if (p.kind == kind) return p;
  }
  throw std::runtime_error(fmt::format("no phase {}", name_of(kind)));
}

/// Main phases follow each other without overlap, except preshape, which lies inside reach.
void expect_in_order(const Movement& movement) {
  double from_s = -1;
  for (const Phase& p : movement.phases) {
    EXPECT_LT(p.begin_s, p.end_s) << name_of(p.kind);
    EXPECT_GE(p.confidence, 0) << name_of(p.kind);
    EXPECT_LE(p.confidence, 1) << name_of(p.kind);
    if (main_phase_of(p.kind) != p.kind) continue;
    if (p.kind == PhaseKind::preshape) {
      EXPECT_GE(p.begin_s, phase(movement, PhaseKind::reach).begin_s);
      EXPECT_LE(p.end_s, phase(movement, PhaseKind::reach).end_s);
      continue;
    }
    EXPECT_GE(p.begin_s, from_s) << name_of(p.kind);
    from_s = p.end_s;
  }
  EXPECT_LT(movement.begin_s, movement.end_s);
}

/// Time from the start of a minimum-jerk stroke until its speed is `share` of its peak.
double rise_s(double share, double length_s) {
  return length_s * (1 - std::sqrt(1 - std::sqrt(share))) / 2;
}

TEST(Segment, FindsThePhasesOfADrinkingCycle) {
  const auto movements = segment(drinking_hand().motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  for (const Phase& p : movements[0].phases) {
    EXPECT_LT(p.begin_s, p.end_s) << name_of(p.kind);
    EXPECT_GT(p.confidence, 0.8) << name_of(p.kind);
    EXPECT_LE(p.confidence, 1.0) << name_of(p.kind);
  }
  EXPECT_EQ(movements[0].target, "");
}

TEST(Segment, BoundariesAreWhereSpeedPassesFivePercentOfTheBoutsOwnPeak) {
  for (const double noise_m : {0.0, 0.0005}) {
    SyntheticHand hand = drinking_hand();
    hand.noise_m = noise_m;
    const auto movements = segment(hand.motion(), {});
    ASSERT_EQ(movements.size(), 1u);
    const PhaseKind phases[] = {PhaseKind::reach, PhaseKind::transport, PhaseKind::return_phase};
    for (int k = 0; k < 3; ++k) {
      const auto& stroke = hand.strokes[static_cast<std::size_t>(k)];
      const double rise = rise_s(0.05, stroke.length_s);
      const Phase& p = phase(movements[0], phases[k]);
      EXPECT_NEAR(p.begin_s, stroke.begin_s + rise, 0.02) << name_of(phases[k]) << noise_m;
      EXPECT_NEAR(p.end_s, stroke.begin_s + stroke.length_s - rise, 0.02)
          << name_of(phases[k]) << noise_m;
    }
  }
}

TEST(Segment, PreshapeLiesInsideTheReachAndGraspFollowsIt) {
  const auto movements = segment(drinking_hand().motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  const Phase &reach = phase(movements[0], PhaseKind::reach),
              &preshape = phase(movements[0], PhaseKind::preshape);
  const Phase &grasp = phase(movements[0], PhaseKind::grasp),
              &lift = phase(movements[0], PhaseKind::transport);
  // 10 % of the opening's rise: 10 τ³ − 15 τ⁴ + 6 τ⁵ = 0.1 at τ = 0.2466.
  EXPECT_NEAR(preshape.begin_s, 0.85 + 0.2466 * 0.45, 0.03);
  EXPECT_EQ(preshape.end_s, reach.end_s);
  EXPECT_EQ(grasp.begin_s, reach.end_s);
  EXPECT_EQ(grasp.end_s, lift.begin_s);
}

TEST(Segment, PlansAsFarAsAsked) {
  SegmentOptions options;
  const HumanMotion motion = drinking_hand().motion();
  for (const PhaseKind until : {PhaseKind::grasp, PhaseKind::transport, PhaseKind::return_phase}) {
    options.plan_until = until;
    const auto movements = segment(motion, options);
    ASSERT_EQ(movements.size(), 1u);
    EXPECT_EQ(movements[0].begin_s, phase(movements[0], PhaseKind::reach).begin_s);
    EXPECT_EQ(movements[0].end_s, phase(movements[0], until).end_s);
  }
}

/// Arm and finger go opposite ways as the hand arrives, so that the tip nearly stands still in
/// between, and then on; 6 % of the reach's peak, 18 % and 34 %.
TEST(Segment, AHandThatClosesAfterTheArmHasArrivedIsStillReaching) {
  for (const double closing_m : {0.01, 0.03, 0.055}) {
    SyntheticHand hand = drinking_hand();
    const Vec3 back(0, -closing_m, 0);
    hand.strokes[1].begin_s = 2.3;
    hand.finger = {{1.35, 0.5, back}, {4.2, 0.4, -back}};
    hand.opening = {{0, 0.09}, {0.85, 0.09}, {1.2, 0.13}, {1.35, 0.13}, {1.85, 0.13 - closing_m}};
    const auto movements = segment(hand.motion(), {});
    ASSERT_EQ(movements.size(), 1u) << closing_m;
    const double level = 0.05 * hand.strokes[0].by.norm() / hand.strokes[0].length_s;
    const double rise = rise_s(level / (closing_m / 0.5), 0.5);
    EXPECT_NEAR(phase(movements[0], PhaseKind::reach).end_s, 1.85 - rise, 0.03) << closing_m;
    EXPECT_NEAR(phase(movements[0], PhaseKind::grasp).begin_s, 1.85 - rise, 0.03) << closing_m;
  }
}

TEST(Segment, AHandThatLetsGoBeforeTheArmSetsOutIsReturning) {
  SyntheticHand hand = drinking_hand();
  const Vec3 home = hand.strokes[2].by;
  const Vec3 open = -0.02 * home.normalized();
  hand.finger = {{2.95, 0.35, open}};
  hand.opening = {{0, 0.09},    {0.85, 0.09}, {1.3, 0.13}, {1.7, 0.11},
                  {2.95, 0.11}, {3.3, 0.13},  {4.0, 0.09}};
  const auto movements = segment(hand.motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  const double share = 0.05 * (home.norm() / hand.strokes[2].length_s) / (0.02 / 0.35);
  EXPECT_NEAR(phase(movements[0], PhaseKind::return_phase).begin_s, 2.95 + rise_s(share, 0.35),
              0.03);
}

TEST(Segment, TwoPeaksWithAShallowDipAreOneReach) {
  SyntheticHand hand = drinking_hand();
  // A correction of the same direction that overlaps the reach: dips to 0.65 of the smaller peak.
  hand.strokes = {{0.8, 0.7, Vec3(0.06, 0.20, 0.06)},
                  {1.2, 0.5, Vec3(0.01, 0.11, 0)},
                  {2.0, 0.9, Vec3(-0.1, -0.25, 0.4)},
                  {3.2, 0.8, Vec3(0.03, -0.06, -0.46)}};
  const auto movements = segment(hand.motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  EXPECT_NEAR(phase(movements[0], PhaseKind::reach).end_s, 1.7, 0.06);
}

TEST(Segment, AReachWithoutAPauseEndsAtTheSlowestPoint) {
  SyntheticHand hand = drinking_hand();
  // Reach ends at 1.6, lift starts at 1.5: the hand never stops; the slowest point is between.
  hand.strokes[1].begin_s = 1.5;
  const auto movements = segment(hand.motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  const Phase &grasp = phase(movements[0], PhaseKind::grasp),
              &reach = phase(movements[0], PhaseKind::reach);
  EXPECT_GT(grasp.begin_s, 1.45);
  EXPECT_LT(grasp.end_s, 1.65);
  EXPECT_NEAR(grasp.end_s - grasp.begin_s, SegmentOptions{}.min_grasp_s, 1e-9);
  EXPECT_EQ(reach.end_s, grasp.begin_s);
  EXPECT_LT(grasp.confidence, 1);
}

TEST(Segment, TwoCyclesAreTwoMovements) {
  SyntheticHand hand = drinking_hand();
  hand.length_s = 10;
  for (std::size_t k = 0; k < 3; ++k) {
    auto stroke = hand.strokes[k];
    stroke.begin_s += 4.5;
    hand.strokes.push_back(stroke);
  }
  for (std::size_t k = 1, n = hand.opening.size(); k < n; ++k) {
    hand.opening.emplace_back(hand.opening[k].first + 4.5, hand.opening[k].second);
  }
  hand.noise_m = 0.0003;
  const auto movements = segment(hand.motion(), {});
  ASSERT_EQ(movements.size(), 2u);
  for (const Movement& movement : movements) {
    EXPECT_THAT(kinds(movement),
                ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                            PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  }
  EXPECT_EQ(movements[0].index, 0);
  EXPECT_EQ(movements[1].index, 1);
  EXPECT_NEAR(movements[1].begin_s - movements[0].begin_s, 4.5, 0.02);
}

TEST(Segment, AReachThatTouchesATargetHasNoGrasp) {
  SyntheticHand hand;
  hand.strokes = {{0.8, 0.9, Vec3(0, 0.25, 0)}, {2.5, 0.9, Vec3(0, -0.25, 0)}};
  const auto movements = segment(hand.motion(), {});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::hold, PhaseKind::return_phase));
  const Phase& reach = phase(movements[0], PhaseKind::reach);
  EXPECT_EQ(movements[0].begin_s, reach.begin_s);
  EXPECT_NEAR(movements[0].end_s, reach.end_s + SegmentOptions{}.hold_after_touch_s, 1e-9);
}

TEST(Segment, ARecordedObjectThatMovesMarksTheTransport) {
  SyntheticHand hand = drinking_hand();
  hand.opening = {{0, 0.09}};  // no help from the hand
  SceneObject box;
  box.name = "box";
  box.shape = Shape::sphere;
  box.size = {0.02};
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i;
    box.time.push_back(t);
    box.position.push_back(Vec3(0.23, 0.35, 0.08) +
                           SyntheticHand::progress((t - 1.9) / 0.9) * Vec3(-0.1, -0.25, 0.4));
    box.orientation.push_back(Quat::Identity());
  }
  const auto movements = segment(hand.motion(), {}, {box});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "box");
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  EXPECT_NEAR(phase(movements[0], PhaseKind::grasp).end_s, 1.9 + rise_s(0.05, 0.9), 0.01);
}

TEST(Segment, AHandThatPausesBeforeItHasTheObjectGraspsWhereItHasIt) {
  SyntheticHand hand = drinking_hand();
  const SyntheticHand::Stroke& lift = hand.strokes[1];
  const auto gone_m = [&](double t) {
    return SyntheticHand::progress((t - lift.begin_s) / lift.length_s) * lift.by.norm();
  };
  for (double before_m = 0; before_m < 0.06; before_m += 0.002) {  // it has gone on by so much
    SceneObject box;
    box.name = "box";
    for (int i = 0; i <= 500; ++i) {
      const double t = 0.01 * i;
      box.time.push_back(t);
      box.position.push_back(Vec3(0.23, 0.35, 0.08) +
                             std::max(0.0, gone_m(t) - before_m) * lift.by.normalized());
      box.orientation.push_back(Quat::Identity());
    }
    SegmentOptions options;
    const double set_out_s =
        phase(segment(hand.motion(), options, {box}).at(0), PhaseKind::grasp).end_s;
    EXPECT_NEAR(set_out_s, 1.9 + rise_s(0.05, 0.9), 0.01);
    options.until_grasped = true;
    const Movement movement = segment(hand.motion(), options, {box}).at(0);
    expect_in_order(movement);
    // The object is seen to move within a frame after it has gone min_object_displacement; the
    // hand, which has it as it has gone before_m, is then twice min_object_displacement farther
    // than at the grasp's end.
    const double seen_s = [&] {
      double t = lift.begin_s;
      while (gone_m(t) < before_m + options.min_object_displacement) t += 0.01;
      return t;
    }();
    const double taken_s = phase(movement, PhaseKind::grasp).end_s;
    if (taken_s > set_out_s + 1e-9) {
      EXPECT_NEAR(gone_m(seen_s) - gone_m(taken_s), 2 * options.min_object_displacement, 2e-4)
          << before_m;
    } else {
      EXPECT_LT(gone_m(seen_s) - gone_m(set_out_s), 2 * options.min_object_displacement)
          << before_m;
    }
  }
}

TEST(Segment, PhasesKeepTheirOrderWhereverTheObjectMoves) {
  for (double lift_s = 1.0; lift_s < 4.5; lift_s += 0.03) {
    SceneObject box;
    box.name = "box";
    for (int i = 0; i <= 500; ++i) {
      box.time.push_back(0.01 * i);
      box.position.push_back(Vec3(0.23, 0.35, 0.08) +
                             SyntheticHand::progress((0.01 * i - lift_s) / 0.9) *
                                 Vec3(-0.1, -0.25, 0.4));
      box.orientation.push_back(Quat::Identity());
    }
    SyntheticHand hand = drinking_hand();
    hand.strokes[1].begin_s = 1.5;  // no pause between reach and lift
    for (const Movement& movement : segment(hand.motion(), {}, {box})) expect_in_order(movement);
  }
}

TEST(Segment, ARecordingThatStartsOrEndsInAMovementIsLessSure) {
  const HumanMotion whole = drinking_hand().motion();
  const auto cut = [&](std::size_t first, std::size_t last) {
    HumanMotion part;
    part.tip = Array2D<Vec3>(last - first, kFingerCount, unknown_point());
    for (std::size_t i = first; i < last; ++i) {
      part.time.push_back(whole.time[i]);
      part.wrist.push_back(whole.wrist[i]);
      for (std::size_t k = 0; k < kFingerCount; ++k) part.tip(i - first, k) = whole.tip(i, k);
    }
    return part;
  };
  const double sure = phase(segment(whole, {})[0], PhaseKind::reach).confidence;
  const auto late = segment(cut(100, 501), {});  // 0.2 s into the reach
  ASSERT_EQ(late.size(), 1u);
  EXPECT_NEAR(late[0].begin_s, 1.0, 1e-9);
  EXPECT_LT(phase(late[0], PhaseKind::reach).confidence, sure - 0.3);
  const auto early = segment(cut(0, 235), {});  // ends in the lift
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(kinds(early[0]).back(), PhaseKind::transport);
  EXPECT_LT(phase(early[0], PhaseKind::transport).confidence, 0.6);
  for (std::size_t last = 1; last < 501; last += 7) {
    for (const HumanMotion& part : {cut(0, last), cut(501 - last, 501)}) {
      for (const Movement& movement : segment(part, {})) expect_in_order(movement);
    }
  }
}

TEST(Segment, WhatFollowsAReachWithoutItsBeginningIsNoReach) {
  SyntheticHand hand = drinking_hand();
  const std::vector<SyntheticHand::Stroke> once = hand.strokes;
  for (SyntheticHand::Stroke stroke : once) {
    stroke.begin_s += 5;
    hand.strokes.push_back(stroke);
  }
  hand.length_s = 10;
  const HumanMotion whole = hand.motion();
  ASSERT_EQ(segment(whole, {}).size(), 2u);
  const auto from_half_reach = [&](std::size_t last) {
    HumanMotion part;
    const std::size_t first = 130;  // the reach is fastest in frame 120
    part.tip = Array2D<Vec3>(last - first, kFingerCount, unknown_point());
    for (std::size_t i = first; i < last; ++i) {
      part.time.push_back(whole.time[i]);
      part.shoulder.push_back(hand.start + Vec3(0, -0.3, 0.3));
      part.wrist.push_back(whole.wrist[i]);
      for (std::size_t k = 0; k < kFingerCount; ++k) part.tip(i - first, k) = whole.tip(i, k);
    }
    return part;
  };
  EXPECT_THAT(segment(from_half_reach(501), {}), IsEmpty());
  const auto movements = segment(from_half_reach(1001), {});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].index, 0);
  EXPECT_NEAR(movements[0].begin_s, 5.8, 0.1);
}

TEST(Segment, UnseenTipsAreBridgedByTheWrist) {
  HumanMotion motion = drinking_hand().motion();
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (i % 50 < 5) motion.tip(i, 1) = unknown_point();
    if (i > 120 && i < 128) motion.wrist[i] = motion.tip(i, 1) = unknown_point();
  }
  const auto movements = segment(motion, {});
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_THAT(kinds(movements[0]),
              ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                          PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
  EXPECT_LT(phase(movements[0], PhaseKind::reach).confidence,
            phase(segment(drinking_hand().motion(), {})[0], PhaseKind::reach).confidence);
}

TEST(Segment, NothingSeenShortOrStillGivesNoMovement) {
  EXPECT_THAT(segment(HumanMotion{}, {}), IsEmpty());
  SyntheticHand still;
  still.noise_m = 0.0005;
  EXPECT_THAT(segment(still.motion(), {}), IsEmpty());
  HumanMotion unseen = drinking_hand().motion();
  for (Vec3& tip : unseen.tip.values) tip = unknown_point();
  for (Vec3& wrist : unseen.wrist) wrist = unknown_point();
  EXPECT_THAT(segment(unseen, {}), IsEmpty());
  SyntheticHand brief = drinking_hand();
  brief.length_s = 0.05;
  EXPECT_THAT(segment(brief.motion(), {}), IsEmpty());
  HumanMotion stopped = drinking_hand().motion();
  for (double& t : stopped.time) t = 1;
  EXPECT_THAT(segment(stopped, {}), IsEmpty());
}

/// A hand that does not go anywhere: no reach, but a movement if the whole recording is one.
TEST(Segment, AWholeRecordingIsOneMovementWhateverMoves) {
  SyntheticHand gestures;
  gestures.length_s = 3;
  gestures.opening = {{0, 0.09}, {1, 0.02}, {2, 0.09}};
  HumanMotion motion = gestures.motion();
  for (std::size_t i = 0; i < 20; ++i) {  // not seen from the first frame on
    motion.wrist[i] = unknown_point();
    for (std::size_t finger = 0; finger < kFingerCount; ++finger)
      motion.tip(i, finger) = unknown_point();
  }
  SegmentOptions options;
  options.whole_recording = true;
  const std::vector<Movement> movements = segment(motion, options);
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].begin_s, motion.time[20]);
  EXPECT_EQ(movements[0].end_s, motion.time.back());
  EXPECT_THAT(movements[0].phases, IsEmpty());
  for (Vec3& tip : motion.tip.values) tip = unknown_point();
  for (Vec3& wrist : motion.wrist) wrist = unknown_point();
  EXPECT_THAT(segment(motion, options), IsEmpty());
}

TEST(SegmentOptions, CheckNamesTheKey) {
  SegmentOptions options;
  EXPECT_EQ(validation_error(options), "");
  options.plan_until = PhaseKind::preshape;
  EXPECT_THAT(validation_error(options), testing::StartsWith("plan_until: "));
}

}  // namespace
}  // namespace morphe::segment
