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
    return [&called, &check, name, to](const Checked&) {
      called += name;
      return Made{{to, check(to)}};
    };
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
  const Rung dead_end = [](const Checked& best) {
    return Made{best, {Reason::unreachable, "no posture"}, true};
  };
  const Rung never = [](const Checked& best) {
    ADD_FAILURE() << "no rung can help";
    return Made{best};
  };
  const Outcome<RepairResult> result = repair_path({dead_end, never}, {path, findings}, {});
  EXPECT_EQ(result.refusal.reason, Reason::unreachable);
  EXPECT_EQ(result.refusal.detail, "no posture");
  EXPECT_FALSE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, path.position);
  EXPECT_EQ(result.value.remaining.size(), 1u);
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
