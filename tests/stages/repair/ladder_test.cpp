#include "stages/repair/ladder.hpp"

#include <gtest/gtest.h>

#include "tests/stages/repair/planar_arm.hpp"

namespace morphe::repair {
namespace {

using test::kFrom;
using test::kTo;

TEST(Ladder, ClimbsInOrderAndStopsWhereNothingIsWrong) {
  // Tracking errors alone: 3 mm on the path, 30 mm on the course, none on what is free.
  const JointPath path = test::sweep(kFrom, kTo), free = test::sweep(kTo, kFrom);
  const Check check = [&](const JointPath& p) -> std::vector<Finding> {
    if (p.position == free.position) return {};
    return {{0.5, 0.5, Cause::tracking, "tip", "", p.position == path.position ? 0.003 : 0.03}};
  };
  std::string called;
  const auto logged = [&](char name, const JointPath& to) -> Rung {
    return {std::string(1, name), [&called, &check, name, to](const Checked&) {
              called += name;
              return Made{{to, check(to)}};
            }};
  };
  JointPath worse = path;
  worse.position.row(50) *= 0.5;
  const Checked start{path, check(path)};
  Made made = climb({logged('a', worse), logged('b', free), logged('c', path)}, start);
  EXPECT_EQ(called, "ab");
  EXPECT_EQ(made.checked.path.position, free.position);
  called.clear();
  made = climb({logged('a', worse), if_nearly_free(logged('b', worse))}, start);
  EXPECT_EQ(called, "ab");
  EXPECT_EQ(made.checked.path.position, path.position) << "what is worse is not kept";
  called.clear();
  climb({if_nearly_free(logged('b', free))}, {worse, check(worse)});
  EXPECT_EQ(called, "") << "30 mm off";
}

TEST(Ladder, ARungMayEndIt) {
  const JointPath path = test::sweep(kFrom, kTo);
  const std::vector<Finding> findings{{0.5, 0.5, Cause::tracking, "thumb_tip", "", 0.012}};
  const Rung dead_end{"dead end", [](const Checked& best) {
                        return Made{best, {Reason::unreachable, "no posture"}, true};
                      }};
  const Rung never{"never", [](const Checked& best) {
                     ADD_FAILURE() << "no rung can help";
                     return Made{best};
                   }};
  const Outcome<RepairResult> result = repair_path({dead_end, never}, {path, findings});
  EXPECT_EQ(result.refusal.reason, Reason::unreachable);
  EXPECT_EQ(result.refusal.detail, "no posture");
  EXPECT_FALSE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, path.position);
  EXPECT_EQ(result.value.remaining.size(), 1u);
  ASSERT_EQ(result.value.steps.size(), 1u);
  EXPECT_EQ(result.value.steps[0].ended, "no posture");
}

TEST(Ladder, ItsStepsSayWhatEachRungChangedAndLeft) {
  const JointPath path = test::sweep(kFrom, kTo);
  JointPath nudged = path;
  nudged.position(40, 0) += 0.25;
  nudged.position(60, 1) -= 0.125;
  const Finding touch{0.4, 0.6, Cause::object, "palm", "post", 0.02},
      off{0.5, 0.5, Cause::tracking, "tip", "", 0.003};
  const Rung nudge{"nudge", [&](const Checked&) { return Made{{nudged, {off}}}; }};
  const Rung worse{"worse", [&](const Checked& best) {
                     return Made{{path, {touch, off}},
                                 {},
                                 false,
                                 "tired",
                                 {step_of("first try", best, {{path, {touch}}}, false)}};
                   }};
  const Made made = climb({nudge, worse}, {path, {touch, off}});
  ASSERT_EQ(made.steps.size(), 3u);
  const RepairStep &kept = made.steps[0], &tired = made.steps[1], &attempt = made.steps[2];
  EXPECT_EQ(kept.name, "nudge");
  EXPECT_EQ(kept.level, 0);
  EXPECT_TRUE(kept.kept);
  EXPECT_EQ(kept.begin_s, path.demonstration_time[40]);
  EXPECT_EQ(kept.end_s, path.demonstration_time[60]);
  EXPECT_DOUBLE_EQ(kept.change, 0.25);
  EXPECT_EQ(kept.findings, 1);
  EXPECT_EQ(kept.collisions, 0);
  EXPECT_EQ(kept.others, 0.003);
  EXPECT_EQ(kept.worst, sentence(off));
  EXPECT_FALSE(tired.kept);
  EXPECT_EQ(tired.ended, "tired");
  EXPECT_EQ(tired.worst, sentence(touch)) << "collisions first";
  EXPECT_EQ(tired.collisions, 0.02);
  EXPECT_EQ(attempt.level, 1);
  EXPECT_EQ(attempt.name, "first try");
}

TEST(Ladder, AFreePathHasNoStep) {
  const Made made = climb({{"never", [](const Checked& best) { return Made{best}; }}},
                          {test::sweep(kFrom, kTo), {}});
  EXPECT_TRUE(made.steps.empty());
}

TEST(Ladder, DepthOfCollisionsComesFirst) {
  const auto finding = [](Cause cause, double depth) {
    return Finding{0, 1, cause, "", "", depth};
  };
  const Finding touch = finding(Cause::self, 0.001), crash = finding(Cause::table, 0.05),
                off = finding(Cause::tracking, 0.3);
  EXPECT_TRUE(less_bad({}, {off}));
  EXPECT_TRUE(less_bad({off}, {touch}));
  EXPECT_TRUE(less_bad({touch, touch, touch}, {crash})) << "three millimetres against fifty";
  EXPECT_TRUE(less_bad({touch}, {touch, off}));
  EXPECT_FALSE(less_bad({touch, off}, {touch, off}));
}

}  // namespace
}  // namespace morphe::repair
