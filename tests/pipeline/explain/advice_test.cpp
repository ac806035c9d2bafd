#include "pipeline/explain/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/explain/reasons.hpp"
#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::explain {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const robot::Robot& arm() {
  static const robot::Robot robot(certify::planar_arm());
  return robot;
}

/// The arm at rest; its first tip's goal is `off_m` above it, from 1 s to 2 s in the grasp.
Plan resting_plan(double off_m, Reason reason) {
  Plan plan;
  plan.reason = reason;
  plan.movement.end_s = 2;
  plan.movement.phases = {{PhaseKind::reach, 0, 1}, {PhaseKind::grasp, 1, 2}};
  Goals& goals = plan.goals;
  goals.time = {0, 0.5, 1, 2};
  goals.tip_position = Array2D<Vec3>(4, 2, unknown_point());
  goals.reachable = Array2D<std::uint8_t>(4, 2, 1);
  for (std::size_t f = 0; f < 4; ++f) goals.tip_position(f, 0) = Vec3(0.55, 0.04, off_m);
  plan.path.position = JointRows::Zero(4, 3);
  plan.path.demonstration_time = goals.time;
  plan.path.origin.assign(4, SampleOrigin::mapped);
  plan.mapped.position = plan.path.position;
  plan.repair.emplace_back();
  return plan;
}

std::vector<std::string> accepted_by(const Plan& plan) {
  for (const Advice& advice : advice_for(arm(), plan)) {
    if (advice.kind == AdviceKind::relaxes_tolerance) return advice.settings;
  }
  return {};
}

TEST(Advice, ATolerancePassesWhatIsMissedByItsOwnNumbers) {
  const Plan plan = resting_plan(0.0123, Reason::tracking);
  EXPECT_THAT(accepted_by(plan), ElementsAre("check.tracking_tolerance_grasp=0.0135"))
      << "12.3 mm, a twentieth and room for smoothing, to half a millimetre; 20 mm are allowed "
         "before the grasp";
  const std::vector<Advice> advice = advice_for(arm(), plan);
  EXPECT_EQ(advice.front().kind, AdviceKind::may_solve) << "what may solve it comes first";
  EXPECT_THAT(text_of(advice.back()),
              HasSubstr("is 12.3 mm from its goal at 0.50 s in the grasp (allowed: 5.0 mm)"));
  EXPECT_THAT(
      accepted_by(resting_plan(0.0301, Reason::tracking)),
      ElementsAre("check.tracking_tolerance_grasp=0.0320", "check.tracking_tolerance=0.0320"));
}

TEST(Advice, BeyondTheFarthestTipItSaysThatThePlanIsOnlyApproximate) {
  const std::vector<Advice> advice = advice_for(arm(), resting_plan(0.08, Reason::tracking));
  EXPECT_THAT(advice.back().sentence, HasSubstr("give the status approximate"));
}

TEST(Advice, AMarginOrDepthPassesAContactUnlessBodiesOverlap) {
  Plan plan = resting_plan(0, Reason::no_path);
  plan.scene.objects = {certify::ball({0, 0.7, 0}, 0.1)};
  plan.remaining_findings = {
      {0.2, 0.4, Cause::object_collision, "forearm", "ball", 0.0004, FindingUnit::metre, 0.001}};
  EXPECT_THAT(accepted_by(plan), ElementsAre("check.required_clearance=0.0005"))
      << "0.6 mm apart, 1 asked for";
  plan.remaining_findings[0].excess = 0.0214;
  EXPECT_TRUE(accepted_by(plan).empty());
  EXPECT_THAT(
      advice_for(arm(), plan),
      Contains(testing::Field(&Advice::sentence,
                              HasSubstr("forearm and ball overlap by 20.4 mm, 0.20–0.40 s"))));
}

/// The plans that are tried for a reason: without a path, with a path that keeps every tolerance,
/// and with one that misses its goals and touches a body.
std::vector<Plan> plans_of(Reason reason) {
  Plan nothing, faulty = resting_plan(0.0123, reason);
  nothing.reason = reason;
  faulty.scene.objects = {certify::ball({0, 0.7, 0}, 0.1)};
  faulty.remaining_findings = {
      {0.2, 0.4, Cause::object_collision, "forearm", "ball", 0.0004, FindingUnit::metre, 0.001}};
  return {nothing, resting_plan(0, reason), faulty};
}

bool mentions(const Advice& advice, const char* word) {
  return text_of(advice).find(word) != std::string::npos;
}

TEST(Advice, EveryReasonHasASentenceAndSomethingToTry) {
  for (std::size_t k = 1; k < enum_count<Reason>(); ++k) {
    const auto reason = static_cast<Reason>(k);
    EXPECT_EQ(explanation_of(reason).reason, reason);
    EXPECT_THAT(std::string(explanation_of(reason).sentence), testing::EndsWith("."));
    for (const Plan& plan : plans_of(reason)) {
      const std::vector<Advice> advice = advice_for(arm(), plan);
      EXPECT_FALSE(advice.empty()) << name_of(reason);
      for (const Advice& one : advice) {
        EXPECT_FALSE(one.sentence.empty());
        EXPECT_EQ(one.settings.empty(), one.kind == AdviceKind::changes_input);
      }
    }
  }
}

/// The key of the config by which only the reasons in the second column may be answered.
struct OwnKey {
  const char* key;
  std::vector<Reason> reasons;
};

TEST(Advice, AgreesWithTheReason) {
  const std::vector<Reason> base{Reason::start_in_collision,
                                 Reason::goal_in_collision,
                                 Reason::unreachable,
                                 Reason::no_path,
                                 Reason::joint_limit,
                                 Reason::jump,
                                 Reason::tracking};
  const std::vector<OwnKey> keys{
      {"map.base_offset.limit", base},
      {"morphe place", base},
      {"repair.attempts", {Reason::start_in_collision, Reason::no_path, Reason::tracking}},
      {"approach", {Reason::no_approach, Reason::no_retreat}},
      {"retime.", {Reason::duration_too_short}},
      {"segment.", {Reason::no_movement, Reason::not_held, Reason::released_in_air}},
      {"human.", {Reason::implausible_arm}},
      {"relative_to", {Reason::no_reference_frame}},
      {"report it", {Reason::invalid_path, Reason::rejected}},
      {"accept", {Reason::doubtful_recording}}};
  for (std::size_t k = 1; k < enum_count<Reason>(); ++k) {
    const auto reason = static_cast<Reason>(k);
    for (const Plan& plan : plans_of(reason)) {
      for (const Advice& advice : advice_for(arm(), plan)) {
        for (const OwnKey& own : keys) {
          if (!mentions(advice, own.key)) continue;
          EXPECT_THAT(own.reasons, Contains(reason)) << name_of(reason) << ": " << text_of(advice);
        }
      }
    }
  }
}

TEST(Advice, NeverNamesTheCommandThatMadeThePlacement) {
  AdviceContext placed;
  placed.placed_by_search = true;
  int named = 0;
  for (std::size_t k = 1; k < enum_count<Reason>(); ++k) {
    for (const Plan& plan : plans_of(static_cast<Reason>(k))) {
      for (const Advice& advice : advice_for(arm(), plan))
        named += mentions(advice, "morphe place");
      for (const Advice& advice : advice_for(arm(), plan, placed))
        EXPECT_FALSE(mentions(advice, "morphe place")) << text_of(advice);
    }
  }
  EXPECT_GT(named, 0) << "without a search it is advised";
}

TEST(Advice, AsksForMoreThanTheConfigDoes) {
  const Plan plan = plans_of(Reason::no_path).back();
  AdviceContext context;
  EXPECT_THAT(advice_for(arm(), plan, context).front().settings,
              ElementsAre("map.base_offset.limit=0.1"));
  context.base_offset_limit_m = 0.1;
  context.map_starts = 96;
  context.repair_attempts = 6;
  std::string text;
  for (const Advice& advice : advice_for(arm(), plan, context)) text += text_of(advice) + "\n";
  EXPECT_THAT(text, testing::Not(HasSubstr("base_offset")));
  EXPECT_THAT(text, HasSubstr("map.starts=384"));
  EXPECT_THAT(text, HasSubstr("repair.attempts=12"));
}

TEST(Advice, ReadsItsContextFromAStoredConfig) {
  EXPECT_TRUE(
      advice_context("robot: {file: r.yaml}\nplacement: {found_by: place}").placed_by_search);
  const AdviceContext context =
      advice_context("robot: {file: r.yaml}\nmap: {starts: 7, base_offset: {limit: 0.05}}");
  EXPECT_FALSE(context.placed_by_search);
  EXPECT_EQ(context.map_starts, 7);
  EXPECT_EQ(context.base_offset_limit_m, 0.05);
  EXPECT_EQ(advice_context("not: {a: config}").map_starts, AdviceContext{}.map_starts);
}

}  // namespace
}  // namespace morphe::explain
