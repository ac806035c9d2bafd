#include "stages/check/check_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/two_link_arm.hpp"

namespace morphe::check {
namespace {

constexpr double kStep_s = 0.01;

/// Two links of 0.5 m that turn about z, a forearm, a post at the base, a tip at the end.
RobotModel two_links() {
  robot::Robot robot{two_link_arm()};
  RobotModel::Tip tip;
  tip.name = "tip";
  tip.frame = 1;
  tip.transform.translation() = Vec3(0.5, 0, 0);
  robot.tips.push_back(tip);
  robot.capsules.push_back({"column", -1, Vec3(0, 0, -0.2), Vec3(0, 0, 0.2), 0.02, false});
  robot.capsules.push_back({"forearm", 1, Vec3(0.1, 0, 0), Vec3(0.5, 0, 0), 0.01, true});
  return robot;
}

Vec3 tip_of(double shoulder, double elbow) {
  return {0.5 * std::cos(shoulder) + 0.5 * std::cos(shoulder + elbow),
          0.5 * std::sin(shoulder) + 0.5 * std::sin(shoulder + elbow), 0};
}

JointPath path_of(const std::vector<Eigen::Vector2d>& positions) {
  JointPath path;
  path.position.resize(static_cast<Eigen::Index>(positions.size()), 2);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    path.position.row(static_cast<Eigen::Index>(k)) = positions[k];
    path.origin.push_back(SampleOrigin::mapped);
    path.demonstration_time.push_back(kStep_s * static_cast<double>(k));
  }
  return path;
}

SceneObject post(const std::string& name, const Vec3& position, double radius) {
  SceneObject object;
  object.name = name;
  object.shape = Shape::cylinder;
  object.size = {radius, 0.3};
  object.time = {0};
  object.position = {position};
  object.orientation = {Quat::Identity()};
  return object;
}

struct CheckPath : testing::Test {
  RobotModel robot = two_links();
  Scene scene;
  Goals goals;
  Movement movement;
  CheckOptions options;

  std::vector<Finding> findings(const JointPath& path) {
    const robot::Robot made(robot);
    const collision::CollisionWorld world =
        collision::make_world(made, scene, movement, options.tolerances);
    return check_path(world, goals, movement, path, options);
  }
  void goal(double time_s, const Vec3& position) {
    goals.time.push_back(time_s);
    goals.tip_position.values.push_back(position);
    goals.tip_position.rows = goals.time.size();
    goals.tip_position.cols = 1;
  }
};

void expect_finding(const Finding& found, Cause cause, const std::string& first,
                    const std::string& second, int begin, int end, double depth,
                    double tolerance = 1e-12) {
  EXPECT_EQ(found.cause, cause);
  EXPECT_EQ(found.subject, first);
  EXPECT_EQ(found.other_body, second);
  EXPECT_NEAR(found.begin_s, kStep_s * begin, 1e-12);
  EXPECT_NEAR(found.end_s, kStep_s * end, 1e-12);
  EXPECT_NEAR(found.excess, depth, tolerance);
}

TEST_F(CheckPath, FreePathHasNoFindings) {
  std::vector<Eigen::Vector2d> positions;
  for (int k = 0; k < 20; ++k) {
    positions.push_back({0.01 * k, 0.02 * k});
    goal(kStep_s * k, tip_of(0.01 * k, 0.02 * k) + Vec3(0.019, 0, 0));
  }
  scene.objects = {post("table", {0, -0.5, 0}, 0.1)};
  EXPECT_TRUE(findings(path_of(positions)).empty());
  options.engine = Engine::fcl;
  EXPECT_TRUE(findings(path_of(positions)).empty());
  EXPECT_TRUE(findings(path_of({})).empty());
}

/// The elbow folds until what the hand holds at its end would go through the column.
TEST_F(CheckPath, WhatIsCarriedMeetsTheArm) {
  robot.frames[1].name = "hand";
  robot.capsules[0].radius = 0.05;
  movement.target = "cup";
  movement.phases = {{PhaseKind::grasp, 0, 0.1, 1}, {PhaseKind::transport, 0.1, 0.5, 1}};
  SceneObject cup = post("cup", {1.058, 0, 0}, 0.05);
  cup.attach_s = 0.1;
  std::vector<Eigen::Vector2d> positions;
  for (int k = 0; k <= 50; ++k) {
    positions.push_back({0, k < 10 ? 0 : k < 40 ? 0.1 * (k - 10) : 3 - 0.05 * (k - 40)});
  }
  // Where the elbow is so far that |0.5 + 0.558 exp(i q)| = 0.05 + 0.05 + the margin.
  const double touching = std::acos((0.101 * 0.101 - 0.25 - 0.558 * 0.558) / 0.558);
  const int first = 10 + static_cast<int>(touching / 0.1),
            last = 40 + static_cast<int>((3 - touching) / 0.05) + 1;
  for (const Engine engine : {Engine::analytic, Engine::fcl}) {
    options.engine = engine;
    cup.attached_frame = "";
    scene.objects = {cup};
    EXPECT_TRUE(findings(path_of(positions)).empty());
    cup.attached_frame = "hand";
    scene.objects = {cup};
    const auto found = findings(path_of(positions));
    ASSERT_EQ(found.size(), 1u);
    const double nearest = std::abs(std::polar(0.558, 3.0) + 0.5);
    expect_finding(found[0], Cause::object_collision, "column", "cup", first, last, 0.101 - nearest,
                   1e-9);
    // Put down before: the hand goes on without it.
    cup.release_s = 0.3;
    scene.objects = {cup};
    EXPECT_TRUE(findings(path_of(positions)).empty());
    cup.release_s = kUnknown;
  }
}

TEST_F(CheckPath, JointsBeyondTheirLimitsAreJoined) {
  const auto found = findings(path_of({{0, 0.1}, {3.01, 0.1}, {3.02, 0.1}, {3, 0.1}, {-3.5, 0.1}}));
  std::vector<Finding> limits;
  for (const Finding& f : found) {
    if (f.cause == Cause::joint_limit) limits.push_back(f);
  }
  ASSERT_EQ(limits.size(), 2u);
  expect_finding(limits[0], Cause::joint_limit, "shoulder", "", 1, 2, 0.02);
  expect_finding(limits[1], Cause::joint_limit, "shoulder", "", 4, 4, 0.5);
  EXPECT_EQ(limits[0].unit, FindingUnit::radian);
  EXPECT_EQ(limits[0].limit, 3);
  EXPECT_EQ(limits[1].limit, -3);
  EXPECT_TRUE(findings(path_of({{0, 3 + 1e-10}})).empty());
}

TEST_F(CheckPath, AnAngleThatIsNoNumberIsNotFree) {
  const auto found = findings(path_of({{0, 0}, {std::nan(""), 0}, {0, 0}}));
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found, testing::Contains(testing::Field(&Finding::cause, Cause::joint_limit)));
}

TEST_F(CheckPath, TrackingIsJudgedByPhaseAndSkipsUnseenGoals) {
  // Goals every 20 ms, 10 mm beside the tip: too far in the grasp alone, to which the samples
  // beside it count (some of the motion between is its own).
  movement.phases = {{PhaseKind::reach, 0, 0.025, 1},
                     {PhaseKind::grasp, 0.025, 0.045, 1},
                     {PhaseKind::return_phase, 0.046, 1, 1}};
  std::vector<Eigen::Vector2d> positions(11, Eigen::Vector2d(0.2, 0.3));
  for (int k = 0; k <= 5; ++k) goal(2 * kStep_s * k, tip_of(0.2, 0.3) + Vec3(0, 0, 0.01));
  auto found = findings(path_of(positions));
  ASSERT_EQ(found.size(), 1u);
  expect_finding(found[0], Cause::tracking, "tip", "", 2, 5, 0.005);
  // Between a seen goal and one that is not there is none.
  goals.tip_position(2, 0) = unknown_point();
  found = findings(path_of(positions));
  ASSERT_EQ(found.size(), 1u);
  expect_finding(found[0], Cause::tracking, "tip", "", 2, 2, 0.005);
  // Half way between two goals the goal is half way.
  goals.tip_position(3, 0) += Vec3(0, 0, 0.02);
  goals.tip_position(4, 0) += Vec3(0, 0, 0.012);
  found = findings(path_of(positions));
  ASSERT_EQ(found.size(), 2u);
  expect_finding(found[1], Cause::tracking, "tip", "", 6, 8, 0.010);
}

TEST_F(CheckPath, AJumpIsAnIsolatedStep) {
  std::vector<Eigen::Vector2d> positions;
  for (int k = 0; k < 10; ++k) positions.push_back({0.005 * k + (k >= 6 ? 0.2 : 0), 0});
  auto found = findings(path_of(positions));
  ASSERT_EQ(found.size(), 1u);
  expect_finding(found[0], Cause::jump, "shoulder", "", 5, 6, 0.205 - 0.06);
  JointPath path = path_of(positions);
  path.origin[6] = SampleOrigin::planned;
  EXPECT_TRUE(findings(path).empty());
  for (double& time_s : path.demonstration_time) time_s *= 4;  // 0.205 rad in 40 ms
  path.origin[6] = SampleOrigin::mapped;
  EXPECT_TRUE(findings(path).empty());
  // Fast but smooth: no jump.
  positions.clear();
  for (int k = 0; k < 20; ++k) positions.push_back({0.5 - 0.5 * std::cos(0.15 * k), 0});
  options.jump_threshold = 0.03;
  EXPECT_TRUE(findings(path_of(positions)).empty());
}

TEST_F(CheckPath, FindsWhatLiesBetweenSamples) {
  scene.objects = {post("pen", tip_of(0.05, 0) * 0.8, 0.0005),
                   post("table", tip_of(0.15, 0) * 0.8, 0.0005)};
  options.jump_threshold = 1;
  const JointPath path = path_of({{0, 0}, {0.1, 0}, {0.2, 0}, {0.2, 0.01}});
  for (const Engine engine : {Engine::analytic, Engine::fcl}) {
    options.engine = engine;
    const auto found = findings(path);
    ASSERT_EQ(found.size(), 2u) << name_of(engine);
    expect_finding(found[0], Cause::object_collision, "forearm", "pen", 0, 1, 0.006, 0.0056);
    expect_finding(found[1], Cause::table, "forearm", "table", 1, 2, 0.006, 0.0056);
  }
}

TEST_F(CheckPath, FindsTheRobotItself) {
  options.jump_threshold = 1;
  robot.upper[1] = 3.2;
  std::vector<Eigen::Vector2d> positions;
  for (int k = 0; k <= 20; ++k) positions.push_back({0, M_PI * std::min(k, 20 - k) / 10});
  for (const Engine engine : {Engine::analytic, Engine::fcl}) {
    options.engine = engine;
    const auto found = findings(path_of(positions));
    ASSERT_EQ(found.size(), 1u) << name_of(engine);
    // Near the fold the forearm's end lies in the column: free again within one sample (0.16 m).
    expect_finding(found[0], Cause::self_collision, "column", "forearm", 9, 11, 0.031);
  }
}

TEST_F(CheckPath, ContactIsAllowedFromGraspToRelease) {
  scene.objects = {post("cup", tip_of(0, 0) * 0.8 + Vec3(0, 0.048, 0), 0.04)};
  movement.target = "cup";
  movement.phases = {{PhaseKind::reach, 0, 0.02, 1},
                     {PhaseKind::grasp, 0.02, 0.04, 1},
                     {PhaseKind::return_phase, 0.04, 1, 1}};
  const std::vector<Eigen::Vector2d> still(8, Eigen::Vector2d::Zero());  // 2 mm in the cup
  for (const Engine engine : {Engine::analytic, Engine::fcl}) {
    options.engine = engine;
    const auto found = findings(path_of(still));
    ASSERT_EQ(found.size(), 2u) << name_of(engine);
    expect_finding(found[0], Cause::object_collision, "forearm", "cup", 0, 2, 0.003);
    expect_finding(found[1], Cause::object_collision, "forearm", "cup", 4, 7, 0.003);
  }
  options.tolerances.max_penetration = 0.0015;
  const auto deep = findings(path_of(still));
  ASSERT_EQ(deep.size(), 1u);
  expect_finding(deep[0], Cause::object_collision, "forearm", "cup", 0, 7, 0.003);
  EXPECT_EQ(deep[0].limit, options.tolerances.required_clearance) << "outside of the grasp";
}

TEST_F(CheckPath, FindingsAreOrderedByBeginThenCause) {
  scene.objects = {post("pen", tip_of(0, 0) * 0.8, 0.002)};
  movement.phases = {{PhaseKind::hold, 0, 1, 1}};
  goal(0, tip_of(0, 0) + Vec3(0, 0, 0.1));
  const auto found = findings(path_of({{0, 0}, {0, 0}, {0, -3.2}}));
  std::vector<Cause> causes;
  for (std::size_t k = 0; k < found.size(); ++k) {
    causes.push_back(found[k].cause);
    EXPECT_LE(found[k == 0 ? 0 : k - 1].begin_s, found[k].begin_s);
  }
  EXPECT_THAT(causes, testing::ElementsAre(Cause::object_collision, Cause::tracking, Cause::jump,
                                           Cause::self_collision, Cause::joint_limit));
}

}  // namespace
}  // namespace morphe::check
