#include <gmock/gmock.h>

#include "stages/segment/segment.hpp"
#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {
namespace {

const Vec3 kReach(0.06, 0.25, 0), kOver(-0.2, 0.05, 0);
constexpr double kRise_m = 0.2, kStrokes_s = 0.6, kUp_s = 1.9, kDown_s = 3.1, kHome_s = 4.2;

/// Reaches, takes a thing, lifts it by kRise_m, carries it aside, puts it down, and goes home.
SyntheticHand placing_hand() {
  SyntheticHand hand;
  hand.length_s = 5.5;
  hand.strokes = {{0.8, 0.8, kReach},
                  {kUp_s, kStrokes_s, {0, 0, kRise_m}},
                  {2.3, 0.9, kOver},
                  {kDown_s, kStrokes_s, {0, 0, -kRise_m}},
                  {kHome_s, 0.8, -kReach - kOver}};
  hand.opening = {{0, 0.09}, {0.85, 0.09}, {1.3, 0.13}, {1.7, 0.06}, {4.2, 0.06}, {4.6, 0.09}};
  return hand;
}

/// Returns the time at which a minimum-jerk stroke has made a share of its way.
double stroke_time(double begin_s, double length_s, double share) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (SyntheticHand::progress(middle) < share ? low : high) = middle;
  }
  return begin_s + length_s * low;
}

/// A box of 0.06 x 0.06 x 0.12 m, between the tips at the grasp, which goes with the hand.
SceneObject carried_box(const HumanMotion& motion) {
  SceneObject box;
  box.name = "box";
  box.size = {0.06, 0.06, 0.12};
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const double time_s = std::clamp(motion.time[i], kUp_s, kDown_s + kStrokes_s);
    box.time.push_back(motion.time[i]);
    box.position.emplace_back(
        motion.tip(static_cast<std::size_t>(std::lround(100 * time_s)), kIndex) -
        Vec3(0.03, 0, 0.02));
    box.orientation.push_back(Quat::Identity());
  }
  return box;
}

Movement only_movement(const HumanMotion& motion, const std::vector<SceneObject>& objects = {},
                       const SegmentOptions& options = {}, std::string_view task = "") {
  const std::vector<Movement> movements = segment(motion, options, objects, task);
  EXPECT_EQ(movements.size(), 1u);
  return movements.empty() ? Movement{} : movements[0];
}

void expect_task(const Movement& movement) {
  const Phase *lift = last_phase(movement, PhaseKind::lift),
              *place = last_phase(movement, PhaseKind::place),
              *release = last_phase(movement, PhaseKind::release),
              *retreat = last_phase(movement, PhaseKind::retreat),
              *home = last_phase(movement, PhaseKind::home);
  ASSERT_TRUE(lift && place && release && retreat && home);
  EXPECT_NEAR(lift->end_s, stroke_time(kUp_s, kStrokes_s, 0.02 / kRise_m), 0.03);
  EXPECT_NEAR(place->begin_s, stroke_time(kDown_s, kStrokes_s, 1 - 0.02 / kRise_m), 0.03);
  EXPECT_EQ(place->end_s, last_phase(movement, PhaseKind::transport)->end_s);
  EXPECT_EQ(release->begin_s, place->end_s);
  const double way_m = (kReach + kOver).norm();
  EXPECT_NEAR(release->end_s, stroke_time(kHome_s, 0.8, 0.01 / way_m), 0.03);
  EXPECT_NEAR(retreat->end_s, stroke_time(kHome_s, 0.8, 0.1 / way_m), 0.03);
  EXPECT_EQ(retreat->begin_s, release->end_s);
  EXPECT_EQ(home->begin_s, retreat->end_s);
  EXPECT_EQ(home->end_s, last_phase(movement, PhaseKind::return_phase)->end_s);
}

TEST(TaskPhases, AreFoundFromARecordedObject) {
  const HumanMotion motion = placing_hand().motion();
  const Movement movement = only_movement(motion, {carried_box(motion)});
  EXPECT_EQ(movement.target, "box");
  expect_task(movement);
}

TEST(TaskPhases, AreFoundFromTheHandAlone) { expect_task(only_movement(placing_hand().motion())); }

TEST(TaskPhases, AThingThatSlidesIsNeitherLiftedNorPlaced) {
  SyntheticHand hand = placing_hand();
  std::erase_if(hand.strokes,
                [](const SyntheticHand::Stroke& stroke) { return stroke.by.z() != 0; });
  const Movement movement = only_movement(hand.motion());
  EXPECT_EQ(last_phase(movement, PhaseKind::lift), nullptr);
  EXPECT_EQ(last_phase(movement, PhaseKind::place), nullptr);
  EXPECT_NE(last_phase(movement, PhaseKind::release), nullptr);
}

/// A box that is tilted by 0.6 rad about its lower edge stays on the table, although the index tip
/// rises by 42 mm.
TEST(TaskPhases, TiltingOnTheTableIsNoLift) {
  SyntheticHand hand = placing_hand();
  hand.strokes = {{0.8, 0.8, kReach}, {kHome_s, 0.8, -kReach}};
  HumanMotion motion = hand.motion();
  SceneObject box;
  box.name = "box";
  box.size = {0.1, 0.06, 0.12};
  const Vec3 centre = hand.start + kReach - Vec3(0.05, 0, 0.02),
             edge = centre - Vec3(0.05, 0, 0.06);
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const double time_s = motion.time[i];
    const Eigen::AngleAxisd turn(-0.6 * (SyntheticHand::progress((time_s - kUp_s) / kStrokes_s) -
                                         SyntheticHand::progress((time_s - kDown_s) / kStrokes_s)),
                                 Vec3::UnitY());
    for (Vec3* point : {&motion.wrist[i], &motion.tip(i, kThumb), &motion.tip(i, kIndex)})
      *point = edge + turn * (*point - edge);
    box.time.push_back(time_s);
    box.position.push_back(edge + turn * (centre - edge));
    box.orientation.emplace_back(turn);
  }
  EXPECT_GT(motion.tip(280, kIndex).z(), motion.tip(180, kIndex).z() + 0.04);
  const Movement movement = only_movement(motion, {box});
  EXPECT_EQ(movement.target, "box");
  EXPECT_NE(last_phase(movement, PhaseKind::transport), nullptr);
  EXPECT_EQ(last_phase(movement, PhaseKind::lift), nullptr);
  EXPECT_NE(last_phase(only_movement(motion), PhaseKind::lift), nullptr) << "without the object";
}

TEST(TaskPhases, WithoutAReturnTheThingMayStillBeInTheHand) {
  SyntheticHand hand = placing_hand();
  hand.length_s = 3.0;
  const Movement movement = only_movement(hand.motion());
  EXPECT_FALSE(is_put_down(movement));
  EXPECT_NE(last_phase(movement, PhaseKind::lift), nullptr);
  for (const PhaseKind kind :
       {PhaseKind::place, PhaseKind::release, PhaseKind::retreat, PhaseKind::home})
    EXPECT_EQ(last_phase(movement, kind), nullptr) << name_of(kind);
}

TEST(TaskPhases, APlanEndsWithAnyThatMayEndIt) {
  const HumanMotion motion = placing_hand().motion();
  SegmentOptions options;
  for (std::size_t k = 0; k < enum_count<PhaseKind>(); ++k) {
    options.plan_until = static_cast<PhaseKind>(k);
    EXPECT_EQ(validation_error(options).empty(), may_end_plan(options.plan_until));
    if (!may_end_plan(options.plan_until)) continue;
    const Movement movement = only_movement(motion, {}, options);
    EXPECT_EQ(movement.end_s, last_phase(movement, options.plan_until)->end_s);
  }
  options.plan_until = PhaseKind::hold;
  EXPECT_THAT(validation_error(options),
              testing::AllOf(testing::HasSubstr("plan_until"), testing::HasSubstr("release")));
}

TEST(TaskPhases, TheTaskMaySayHowFarIsPlanned) {
  const HumanMotion motion = placing_hand().motion();
  SegmentOptions options;
  options.plan_until_by_task = {{"stack", PhaseKind::retreat}, {"drink", PhaseKind::home}};
  const auto end_s = [&](std::string_view task) {
    return only_movement(motion, {}, options, task).end_s;
  };
  const Movement movement = only_movement(motion);
  EXPECT_EQ(end_s(""), last_phase(movement, PhaseKind::grasp)->end_s);
  EXPECT_EQ(end_s("drinking"), end_s(""));
  EXPECT_EQ(end_s("Stack, then drink"), last_phase(movement, PhaseKind::retreat)->end_s);
  EXPECT_EQ(end_s("drink from the cup"), last_phase(movement, PhaseKind::home)->end_s);
}

TEST(TaskPhases, RefineTheMainPhasesWithoutChangingThem) {
  const Movement movement = only_movement(placing_hand().motion());
  const Phase& release = *last_phase(movement, PhaseKind::release);
  const double middle_s = (release.begin_s + release.end_s) / 2;
  EXPECT_EQ(phase_at(movement.phases, middle_s), PhaseKind::release);
  EXPECT_EQ(main_phase_at(movement.phases, middle_s), PhaseKind::hold);
  EXPECT_FALSE(is_grasping_at(movement, middle_s)) << "the hand lets go";
  EXPECT_EQ(phase_at(movement.phases, movement.phases.front().begin_s - 1), PhaseKind::rest);
}

}  // namespace
}  // namespace morphe::segment
