#include "stages/repair/detour.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/repair/candidate_strategy.hpp"
#include "tests/stages/repair/planar_arm.hpp"

namespace morphe::repair {
namespace {

using test::Bench;
using test::kFrom;
using test::kTo;
using test::post;
using test::sweep;
using ::testing::HasSubstr;

using Change = std::function<JointPath(const JointPath&, const std::vector<Finding>&)>;

RepairStrategy rung(const PathCheck& check, const Change& change) {
  return {"change", [=](const CheckedPath& best) {
            const JointPath path = change(best.path, best.findings);
            return StrategyResult{{path, check(path)}};
          }};
}

/// A ladder without a mapping: what `resolve` gives, detours, and other courses.
struct Repair {
  const Bench& bench;
  PathCheck check = [this](const JointPath& path) { return bench.collisions(path); };
  Change resolve = nullptr;
  RepairOptions options = {};
  NextCandidate next = nullptr;

  Outcome<RepairResult> operator()(const JointPath& path) const {
    DetourContext around{bench.world, options, 42, check, {}};
    if (resolve) around.tracking_recovery = {rung(check, resolve)};
    const CheckedPath start{path, check(path)};
    std::vector<RepairStrategy> ladder = around.tracking_recovery;
    const auto add = [&](const char* name, const auto& make) { ladder.push_back({name, make}); };
    add("detour", [&](const CheckedPath& best) { return detour(around, best); });
    add("from the mapped path",
        [&](const CheckedPath& best) { return detour_from_mapped(start, around, best); });
    CandidateFindings ends;
    if (next) {
      std::vector<RepairStrategy> rungs = around.tracking_recovery;
      rungs.push_back(detour_if_only_collisions(around));
      ladder.push_back(candidate_strategy("courses", std::move(rungs), check, next, ends));
    }
    return repair_path(ladder, start);
  }
};

Outcome<RepairResult> repair(const Bench& bench, const JointPath& path,
                             const Change& resolve = nullptr, const RepairOptions& options = {}) {
  Repair repair{bench};
  repair.resolve = resolve;
  repair.options = options;
  return repair(path);
}

TEST(Repair, LeavesAFreePathAlone) {
  const Bench bench({});
  const JointPath path = sweep(kFrom, kTo);
  const Outcome<RepairResult> result = repair(bench, path);
  EXPECT_EQ(result.failure.reason, Reason::none);
  EXPECT_FALSE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, path.position);
}

TEST(Repair, GoesAroundAPost) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  ASSERT_FALSE(bench.collisions(path).empty());
  ASSERT_LT(bench.densely_sampled_slack(path), 0);

  const Outcome<RepairResult> result = repair(bench, path);
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  EXPECT_TRUE(result.value.repaired);
  EXPECT_TRUE(result.value.remaining.empty());
  EXPECT_GE(bench.densely_sampled_slack(result.value.path), 0);

  const Eigen::Index rows = path.position.rows();
  ASSERT_EQ(result.value.path.position.rows(), rows);
  EXPECT_EQ(result.value.path.demonstration_time, path.demonstration_time);
  EXPECT_EQ(result.value.path.position.row(0), path.position.row(0));
  EXPECT_EQ(result.value.path.position.row(rows - 1), path.position.row(rows - 1));
  int planned = 0;
  for (Eigen::Index k = 0; k < rows; ++k) {
    const bool same = result.value.path.position.row(k) == path.position.row(k);
    const SampleOrigin origin = result.value.path.origin[static_cast<std::size_t>(k)];
    EXPECT_EQ(origin, same ? SampleOrigin::mapped : SampleOrigin::planned) << k;
    planned += same ? 0 : 1;
  }
  EXPECT_GT(planned, 5);
  EXPECT_LT(planned, rows - 2);
}

TEST(Repair, TheDetourIsSmallAndHasNoCorners) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  const Outcome<RepairResult> result = repair(bench, path);
  ASSERT_TRUE(result.value.repaired);
  // Bending just enough to pass at a radius of 0.81 m takes less than 1.7 rad of any joint.
  EXPECT_LT((result.value.path.position - path.position).cwiseAbs().maxCoeff(), 1.7);
  const Eigen::Index rows = path.position.rows();
  double step = 0, turn = 0;
  for (Eigen::Index k = 1; k + 1 < rows; ++k) {
    const JointVector before =
        result.value.path.position.row(k) - result.value.path.position.row(k - 1);
    const JointVector after =
        result.value.path.position.row(k + 1) - result.value.path.position.row(k);
    step = std::max(step, before.cwiseAbs().maxCoeff());
    turn = std::max(turn, (after - before).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(step, 0.06);
  EXPECT_LT(turn, 0.015);
}

TEST(Repair, FingersFollowTheArmAndTheRestIsTheSame) {
  Bench bench({post("post", 0.9, 0)});
  bench.robot.palm_frame = 1;  // the third joint is the hand's
  bench.robot = robot::Robot(RobotModel(bench.robot));
  const Outcome<RepairResult> result = repair(bench, sweep(kFrom, kTo));
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  EXPECT_GE(bench.densely_sampled_slack(result.value.path), 0);
}

TEST(Repair, SaysWhenThereIsNoPath) {
  // The first link has to cross the post at a radius of 0.2 m; its limits forbid the way behind.
  const Bench bench({post("post", 0.2, 0), post("outer", 0.6, 0)});
  const JointPath path = sweep(kFrom, kTo);
  RepairOptions options;
  options.max_iterations = 300;
  const Outcome<RepairResult> result = repair(bench, path, nullptr, options);
  EXPECT_EQ(result.failure.reason, Reason::no_path);
  EXPECT_THAT(result.failure.detail, HasSubstr("post"));
  EXPECT_EQ(no_path_message(options), "no collision-free path in 3 attempts of 300 iterations");
  EXPECT_FALSE(result.value.repaired);
  EXPECT_FALSE(result.value.remaining.empty());
}

TEST(Repair, SaysWhenAnEndIsInCollision) {
  const JointPath path = sweep(kFrom, kTo);
  const Vec3 tip_at_goal(0.4 * (std::cos(0.9) + std::cos(1.2) + std::cos(1.5)),
                         0.4 * (std::sin(0.9) + std::sin(1.2) + std::sin(1.5)), 0);
  const Bench goal({post("cupboard", tip_at_goal.x(), tip_at_goal.y())});
  const Outcome<RepairResult> at_goal = repair(goal, path);
  EXPECT_EQ(at_goal.failure.reason, Reason::goal_in_collision);
  EXPECT_THAT(at_goal.failure.detail, HasSubstr("link3"));
  EXPECT_THAT(at_goal.failure.detail, HasSubstr("cupboard"));

  const Bench start({post("shelf", 0.4 * std::cos(0.9), -0.4 * std::sin(0.9))});
  EXPECT_EQ(repair(start, path).failure.reason, Reason::start_in_collision);
}

TEST(Repair, TakesWhatTheMappingCanSolveItself) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  JointPath around = repair(bench, path).value.path;
  for (SampleOrigin& origin : around.origin)
    if (origin == SampleOrigin::planned) origin = SampleOrigin::re_solved;
  const Outcome<RepairResult> result =
      repair(bench, path, [&](const JointPath&, const std::vector<Finding>&) { return around; });
  EXPECT_TRUE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, around.position);
  EXPECT_EQ(result.value.path.origin, around.origin);
}

TEST(Repair, DropsASolutionThatMakesItWorse) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  const JointPath without = repair(bench, path).value.path;
  const Outcome<RepairResult> result = repair(bench, path, [&](JointPath worse, const auto&) {
    for (Eigen::Index k = 0; k < 101; ++k)  // there and back: through the post twice
      worse.position.row(k) = path.position.row(k <= 50 ? 2 * k : std::abs(100 - 2 * (k - 50)));
    return worse;
  });
  EXPECT_TRUE(result.value.repaired);
  EXPECT_EQ(result.value.path.position, without.position);
}

TEST(Repair, GoesAroundFromTheMappedPathWhereResolvingLosesTheGoals) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  JointPath aside = path;  // free, but nowhere near what is asked for
  for (Eigen::Index k = 0; k < aside.position.rows(); ++k)
    aside.position.row(k) = kFrom.transpose();
  Repair repair{bench};
  repair.check = [&](const JointPath& p) {
    std::vector<Finding> findings = bench.collisions(p);
    if ((p.position.row(100).transpose() - kTo).norm() > 1e-9) {
      findings.push_back({1, 1, Cause::tracking, "tip", "", 0.1});
    }
    return findings;
  };
  repair.resolve = [&](const JointPath&, const std::vector<Finding>&) { return aside; };
  const Outcome<RepairResult> result = repair(path);
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  EXPECT_TRUE(result.value.repaired);
  EXPECT_TRUE(repair.check(result.value.path).empty());
}

TEST(Repair, AnotherCourseWhereTheGoalIsInCollision) {
  // The post stands where the path ends; the other course ends beside it, and another post stands
  // in its way, so that it takes a detour too.
  const JointVector aside = Vec3(0.9, -0.6, 0.3);
  const JointPath path = sweep(kFrom, kTo), other = sweep(kFrom, aside);
  Bench bench({post("goal", 0.32, 0.5), post("way", 0.9, 0)});
  ASSERT_FALSE(bench.collisions(path).empty());
  Repair repair{bench};
  ASSERT_EQ(repair(path).failure.reason, Reason::goal_in_collision);
  int asked = 0;
  repair.next = [&](bool) -> std::optional<JointPath> {
    return asked++ == 0 ? std::optional(other) : std::nullopt;
  };
  const Outcome<RepairResult> freed = repair(path);
  EXPECT_EQ(freed.failure.reason, Reason::none) << freed.failure.detail;
  EXPECT_TRUE(freed.value.repaired);
  EXPECT_TRUE(bench.collisions(freed.value.path).empty());
  EXPECT_EQ(freed.value.path.position.row(100), other.position.row(100));
  EXPECT_EQ(asked, 1);
}

TEST(Repair, StopsWhereCoursesFailAtTheSamePlace) {
  const Bench bench({});
  const JointPath path = sweep(kFrom, kTo);
  const auto tip = [](double begin_s, double end_s, double depth_m) {
    return Finding{begin_s, end_s, Cause::tracking, "tip", "", depth_m};
  };
  const Finding thumb{0.1, 0.2, Cause::tracking, "thumb", "", 0.002};
  // Of the path and of the courses one after the other: the second fails at another time, the
  // fourth by much less there, and by more elsewhere.
  const std::vector<std::vector<Finding>> findings{
      {tip(0.50, 0.52, 0.0045)},        {tip(0.50, 0.52, 0.0041)},        {tip(0.70, 0.75, 0.0044)},
      {tip(0.51, 0.52, 0.0042), thumb}, {tip(0.50, 0.51, 0.0030), thumb}, {tip(0.50, 0.52, 0.0040)},
      {tip(0.40, 0.60, 0.0200)},        {tip(0.50, 0.52, 0.0041)}};
  Repair repair{bench};
  std::size_t course = 0;
  repair.check = [&](const JointPath&) { return findings.at(course); };
  repair.next = [&](bool) {
    ++course;
    return std::optional(path);
  };
  const Outcome<RepairResult> result = repair(path);
  EXPECT_EQ(course, 6u) << "neither the second nor the fourth fail where the path does";
  EXPECT_EQ(result.failure.reason, Reason::tracking);
  ASSERT_EQ(result.value.remaining.size(), 1u);
  EXPECT_EQ(result.value.remaining[0].excess, 0.0040);
}

TEST(Repair, NamesTheWorstOfWhatPlanningCannotCure) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  Repair repair{bench};
  repair.check = [&](const JointPath& p) {
    std::vector<Finding> findings = bench.collisions(p);
    findings.push_back({0.2, 0.3, Cause::tracking, "index_tip", "", 0.004});
    findings.push_back({0.4, 0.6, Cause::tracking, "thumb_tip", "", 0.020});
    return findings;
  };
  const Outcome<RepairResult> result = repair(path);
  EXPECT_EQ(result.failure.reason, Reason::tracking);
  EXPECT_THAT(result.failure.detail, HasSubstr("thumb_tip"));
  EXPECT_EQ(result.value.remaining.size(), 2u);
  EXPECT_TRUE(bench.collisions(result.value.path).empty());
}

TEST(Repair, TheMappingWinsBackWhatADetourCost) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = sweep(kFrom, kTo);
  const auto tracks = [](const JointPath& p) { return p.origin[1] == SampleOrigin::re_solved; };
  Repair repair{bench};
  repair.check = [&](const JointPath& p) {
    std::vector<Finding> findings = bench.collisions(p);
    if (findings.empty() && !tracks(p))
      findings.push_back({0, 0.1, Cause::tracking, "tip", "", 0.01});
    return findings;
  };
  repair.resolve = [&](JointPath p, const std::vector<Finding>& findings) {
    if (findings.front().cause == Cause::tracking) p.origin[1] = SampleOrigin::re_solved;
    return p;
  };
  repair.options.widen_samples = 5;
  const Outcome<RepairResult> result = repair(path);
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  EXPECT_EQ(result.value.path.origin[1], SampleOrigin::re_solved);
  EXPECT_EQ(result.value.path.origin[50], SampleOrigin::planned);
}

TEST(Repair, TheReferenceRobotTakesItsForearmAroundABall) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  JointVector from = JointVector::Constant(22, 0.2), to = JointVector::Constant(22, 0.3);
  for (int finger = 0; finger < 5; ++finger) from[7 + 3 * finger] = to[7 + 3 * finger] = 0;
  from.head<7>() << 0, 0.6, 0, 1.2, 0, 0.5, 0;
  to.head<7>() << 0.8, 0.8, 0.2, 1.0, 0.2, 0.4, 0.1;
  const JointPath path = sweep(from, to);
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, path.position.row(50), frames);
  const Vec3 elbow = frames[static_cast<std::size_t>(robot.joint_centres[0].frame)].translation();
  const Vec3 palm = frames[static_cast<std::size_t>(robot.palm_frame)].translation();
  SceneObject ball = post("ball", 0, 0);
  ball.shape = Shape::sphere;
  ball.size = {0.04};
  ball.position = {0.5 * (elbow + palm)};

  const Bench bench({ball}, robot);
  ASSERT_FALSE(bench.collisions(path).empty());
  const Outcome<RepairResult> result = repair(bench, path);
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  EXPECT_GE(bench.densely_sampled_slack(result.value.path), 0);
  EXPECT_TRUE((result.value.path.position.row(100) - path.position.row(100)).isZero(0));
}

TEST(Repair, IsTheSameToTheBitOnEveryThread) {
  const Bench bench({post("post", 0.9, 0), post("other", 0.2, 0.55)});
  const JointPath path = sweep(kFrom, kTo);
  std::vector<Outcome<RepairResult>> results(4);
  std::vector<std::thread> threads;
  for (Outcome<RepairResult>& result : results)
    threads.emplace_back([&] { result = repair(bench, path); });
  for (std::thread& thread : threads) thread.join();
  const Outcome<RepairResult> alone = repair(bench, path);
  for (const Outcome<RepairResult>& result : results) {
    EXPECT_EQ(result.value.path.position, alone.value.path.position);
    EXPECT_EQ(result.value.path.origin, alone.value.path.origin);
    EXPECT_EQ(result.failure.reason, alone.failure.reason);
  }
}

}  // namespace
}  // namespace morphe::repair
