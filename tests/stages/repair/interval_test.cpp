#include <gtest/gtest.h>

#include "stages/repair/connect.hpp"
#include "stages/repair/interval_world.hpp"
#include "stages/repair/path_smoothing.hpp"
#include "tests/stages/repair/planar_arm.hpp"

namespace morphe::repair {
namespace {

using test::Bench;
using test::post;
using test::sweep;

TEST(IntervalWorld, TouchingNeedsTheWholeIntervalUnlessLenient) {
  Bench bench({post("cup", 0.9, 0)});
  bench.world.target = 0;
  bench.world.touch_begin_s = 1;
  bench.world.touch_end_s = 2;
  const IntervalWorld inside = interval_world(bench.world, 1.2, 1.8, 0.002, TouchRule::strict);
  EXPECT_EQ(inside.world.environment.touch_begin_s, 1);
  EXPECT_DOUBLE_EQ(inside.world.environment.tolerances.required_clearance, 0.003);
  EXPECT_DOUBLE_EQ(inside.world.environment.tolerances.max_penetration, 0.004);
  const IntervalWorld strict = interval_world(bench.world, 0.5, 1.5, 0, TouchRule::strict);
  EXPECT_TRUE(std::isnan(strict.world.environment.touch_begin_s));
  const IntervalWorld lenient = interval_world(bench.world, 0.5, 1.5, 0, TouchRule::lenient);
  EXPECT_EQ(lenient.world.environment.touch_begin_s, 0.5);
  EXPECT_EQ(lenient.times, std::vector<double>{0.5});
}

TEST(IntervalWorld, WhatMovesIsLookedAtSeveralTimesAndAMovingTargetIsLeftOut) {
  SceneObject moving = post("moving", 0.9, -0.3);
  moving.time = {0, 1};
  moving.position = {Vec3(0.9, -0.3, 0), Vec3(0.9, 0.3, 0)};
  moving.orientation.assign(2, Quat::Identity());
  Bench bench({moving});
  const IntervalWorld interval = interval_world(bench.world, 0, 1, 0, TouchRule::strict);
  EXPECT_EQ(interval.times.front(), 0);
  EXPECT_EQ(interval.times.back(), 1);
  collision::CollisionScratch scratch;
  EXPECT_FALSE(is_state_free(interval, JointVector::Zero(3), scratch));  // free at 0, not at 0.5

  bench.world.target = 0;
  const IntervalWorld carried = interval_world(bench.world, 0, 1, 0, TouchRule::strict);
  EXPECT_TRUE(carried.world.scene->objects.empty());
  EXPECT_EQ(carried.world.environment.target, -1);
  EXPECT_TRUE(is_state_free(carried, JointVector::Zero(3), scratch));
}

TEST(Connect, FollowersKeepOneProportion) {
  const Bench bench({post("post", 0.75, 0)});
  const IntervalWorld interval = interval_world(bench.world, 0, 1, 0, TouchRule::strict);
  const JointVector from = Vec3(-0.9, 0.3, 0.2), to = Vec3(0.9, 0.3, 0.8);
  const ConnectSpace space{{0, 1}, bench.robot.lower, bench.robot.upper};
  const auto vertices = plan_rrt_connect(interval, space, from, to, 3000, 0.1, 7);
  ASSERT_GT(vertices.size(), 2u);
  EXPECT_EQ(vertices.front(), from);
  EXPECT_EQ(vertices.back(), to);
  collision::CollisionScratch scratch;
  for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
    EXPECT_TRUE(is_motion_free(interval, vertices[k], vertices[k + 1], scratch));
    EXPECT_GE(vertices[k][2], 0.2 - 1e-12);
    EXPECT_LE(vertices[k][2], 0.8 + 1e-12);
  }
}

TEST(Spread, PutsASampleOnEveryVertex) {
  const robot::Robot robot(test::planar_arm());
  const std::vector<JointVector> vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0.5, 0)};
  const JointRows rows = resample(robot, vertices, 7);
  ASSERT_EQ(rows.rows(), 7);
  EXPECT_EQ(rows.row(4), vertices[1].transpose());
  EXPECT_NEAR(rows(1, 0), 0.25, 1e-15);
  EXPECT_NEAR(rows(5, 1), 0.25, 1e-15);
  EXPECT_EQ(resample(robot, vertices, 2).rows(), 0);
}

TEST(Shortcut, FindsTheStraightLineWhereNothingIsInTheWay) {
  const Bench bench({});
  const IntervalWorld interval = interval_world(bench.world, 0, 1, 0, TouchRule::strict);
  std::mt19937_64 random(1);
  const auto vertices = shortcut(
      interval, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0.5, -1, 0), Vec3(1, 0, 0)}, 10, random);
  EXPECT_EQ(vertices.size(), 2u);
}

TEST(DrawIn, ReturnsToTheOriginalWhereNothingIsInTheWay) {
  const Bench bench({});
  const JointPath path = sweep(Vec3(-0.9, 0.3, 0.3), Vec3(0.9, 0.3, 0.3));
  const JointRows rows =
      resample(bench.robot, {path.position.row(0), Vec3(0, 1.5, 0.3), path.position.row(100)}, 101);
  JointRows planned = rows;
  std::mt19937_64 random(1);
  pull_towards_original(padded_world(bench.world, 0), path.demonstration_time, path.position, 300,
                        random, planned);
  EXPECT_EQ(planned.row(0), path.position.row(0));
  EXPECT_EQ(planned.row(100), path.position.row(100));
  const double before = (rows - path.position).cwiseAbs().maxCoeff();
  EXPECT_GT(before, 1);
  EXPECT_LT((planned - path.position).cwiseAbs().maxCoeff(), 0.01 * before);
}

}  // namespace
}  // namespace morphe::repair
