#include "stages/repair/repair_strategy.hpp"
#include "core/motion/finding_text.hpp"

#include <gtest/gtest.h>

#include "tests/stages/repair/planar_arm.hpp"

namespace morphe::repair {
namespace {

using test::kFrom;
using test::kTo;

TEST(Ladder, ClimbsInOrderAndStopsWhereNothingIsWrong) {
  // Tracking errors alone: 3 mm on the path, 30 mm on the course, none on what is free.
  const JointPath path = test::sweep(kFrom, kTo), free = test::sweep(kTo, kFrom);
  const PathCheck check = [&](const JointPath& p) -> std::vector<Finding> {
    if (p.position == free.position) return {};
    return {{0.5, 0.5, Cause::tracking, "tip", "", p.position == path.position ? 0.003 : 0.03}};
  };
  std::string called;
  const auto logged = [&](char name, const JointPath& to) -> RepairStrategy {
    return {std::string(1, name), [&called, &check, name, to](const CheckedPath&) {
              called += name;
              return StrategyResult{{to, check(to)}};
            }};
  };
  JointPath worse = path;
  worse.position.row(50) *= 0.5;
  const CheckedPath start{path, check(path)};
  StrategyResult made =
      run_strategies({logged('a', worse), logged('b', free), logged('c', path)}, start);
  EXPECT_EQ(called, "ab");
  EXPECT_EQ(made.candidate.path.position, free.position);
  called.clear();
  made = run_strategies({logged('a', worse), only_if_nearly_free(logged('b', worse))}, start);
  EXPECT_EQ(called, "ab");
  EXPECT_EQ(made.candidate.path.position, path.position) << "what is worse is not kept";
  called.clear();
  run_strategies({only_if_nearly_free(logged('b', free))}, {worse, check(worse)});
  EXPECT_EQ(called, "") << "30 mm off";
}

TEST(Ladder, ARungMayEndIt) {
  const JointPath path = test::sweep(kFrom, kTo);
  const std::vector<Finding> findings{{0.5, 0.5, Cause::tracking, "thumb_tip", "", 0.012}};
  const RepairStrategy dead_end{
      "dead end", [](const CheckedPath& best) {
        return StrategyResult{best, {Reason::unreachable, "no posture"}, true};
      }};
  const RepairStrategy never{"never", [](const CheckedPath& best) {
                               ADD_FAILURE() << "no rung can help";
                               return StrategyResult{best};
                             }};
  const Outcome<RepairResult> result = repair_path({dead_end, never}, {path, findings});
  EXPECT_EQ(result.failure.reason, Reason::unreachable);
  EXPECT_EQ(result.failure.detail, "no posture");
  EXPECT_FALSE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, path.position);
  EXPECT_EQ(result.value.remaining.size(), 1u);
  ASSERT_EQ(result.value.attempts.size(), 1u);
  EXPECT_EQ(result.value.attempts[0].stop_reason, "no posture");
}

TEST(Ladder, ItsStepsSayWhatEachRungChangedAndLeft) {
  const JointPath path = test::sweep(kFrom, kTo);
  JointPath nudged = path;
  nudged.position(40, 0) += 0.25;
  nudged.position(60, 1) -= 0.125;
  const Finding touch{0.4, 0.6, Cause::object_collision, "palm", "post", 0.02},
      off{0.5, 0.5, Cause::tracking, "tip", "", 0.003};
  const RepairStrategy nudge{"nudge", [&](const CheckedPath&) {
                               return StrategyResult{{nudged, {off}}};
                             }};
  const RepairStrategy worse{"worse", [&](const CheckedPath& best) {
                               return StrategyResult{
                                   {path, {touch, off}},
                                   {},
                                   false,
                                   "tired",
                                   {make_repair_step("first try", best, {{path, {touch}}}, false)}};
                             }};
  const StrategyResult made = run_strategies({nudge, worse}, {path, {touch, off}});
  ASSERT_EQ(made.attempts.size(), 3u);
  const RepairStep &kept = made.attempts[0], &tired = made.attempts[1], &attempt = made.attempts[2];
  EXPECT_EQ(kept.name, "nudge");
  EXPECT_EQ(kept.level, 0);
  EXPECT_TRUE(kept.accepted);
  EXPECT_EQ(kept.begin_s, path.demonstration_time[40]);
  EXPECT_EQ(kept.end_s, path.demonstration_time[60]);
  EXPECT_DOUBLE_EQ(kept.max_joint_change, 0.25);
  EXPECT_EQ(kept.finding_count, 1);
  EXPECT_EQ(kept.collision_depth_sum, 0);
  EXPECT_EQ(kept.other_depth_sum, 0.003);
  EXPECT_EQ(kept.worst_finding, sentence(off));
  EXPECT_FALSE(tired.accepted);
  EXPECT_EQ(tired.stop_reason, "tired");
  EXPECT_EQ(tired.worst_finding, sentence(touch)) << "collisions first";
  EXPECT_EQ(tired.collision_depth_sum, 0.02);
  EXPECT_EQ(attempt.level, 1);
  EXPECT_EQ(attempt.name, "first try");
}

TEST(Ladder, AFreePathHasNoStep) {
  const StrategyResult made =
      run_strategies({{"never", [](const CheckedPath& best) { return StrategyResult{best}; }}},
                     {test::sweep(kFrom, kTo), {}});
  EXPECT_TRUE(made.attempts.empty());
}

TEST(Ladder, DepthOfCollisionsComesFirst) {
  const auto finding = [](Cause cause, double depth) {
    return Finding{0, 1, cause, "", "", depth};
  };
  const Finding touch = finding(Cause::self_collision, 0.001), crash = finding(Cause::table, 0.05),
                off = finding(Cause::tracking, 0.3);
  EXPECT_TRUE(is_better({}, {off}));
  EXPECT_TRUE(is_better({off}, {touch}));
  EXPECT_TRUE(is_better({touch, touch, touch}, {crash})) << "three millimetres against fifty";
  EXPECT_TRUE(is_better({touch}, {touch, off}));
  EXPECT_FALSE(is_better({touch, off}, {touch, off}));
}

}  // namespace
}  // namespace morphe::repair
