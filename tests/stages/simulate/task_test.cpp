#include <gtest/gtest.h>

#include "core/math/rotation.hpp"
#include "core/physics/model.hpp"
#include "core/physics/state.hpp"
#include "stages/simulate/results.hpp"
#include "stages/simulate/summary.hpp"
#include "tests/stages/simulate/carrying_gripper.hpp"

namespace morphe::simulate {
namespace {

class Tasks : public testing::Test {
 protected:
  void SetUp() override {
    if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
    options_.torsional_friction_m = 0.005;
  }

  PreparationResult prepared(const Plan& plan) const {
    const PreparationResult result = prepare(carrying_gripper(), plan, options_);
    EXPECT_EQ(result.skip_reason, SkipReason::none) << result.detail;
    EXPECT_TRUE(result.plan.task);
    return result;
  }
  Rollout rollout(const Plan& plan) const {
    const PreparationResult result = prepared(plan);
    return roll_out(result.plan, variation_of(result.plan, options_, "block/000", 0), options_,
                    false);
  }

  SimulateOptions options_;
};

TEST_F(Tasks, ABlockIsCarriedPutDownAndLetGoOf) {
  const Rollout one = rollout(carrying_plan());
  ASSERT_TRUE(one.task);
  EXPECT_EQ(one.task->failure, Failure::none) << name_of(one.task->failure);
  EXPECT_TRUE(one.lift.is_held());
  EXPECT_NEAR(one.task->rise_m, 0.1, 0.002);
  EXPECT_LT(one.task->arm_error, 2);  // mm; the weight of the block alone makes 0.6
  EXPECT_LT(one.task->palm_offset.distance_m, 0.003);
  EXPECT_LT(one.task->palm_offset.angle_deg, 1);
  EXPECT_LT(one.task->carried_error.distance_m, 0.003);
  EXPECT_LT(one.task->place_error.distance_m, 0.003);
  EXPECT_LT(one.task->tilt_deg, 0.1);
  EXPECT_LT(one.task->standing_motion.distance_m, 1e-4);
}

// Two pads of 10 N bear 20 mu N; the block weighs 2.94 N, and the curve up to 100 mm within 0.6 s
// accelerates it by at most 1.6 m/s^2.
TEST_F(Tasks, WithTooLittleFrictionItSlidesOutOfTheHand) {
  const double needed = 0.3 * (9.81 + 10 / std::sqrt(3.0) * 0.1 / (0.6 * 0.6)) / 20;
  for (const double share : {0.7, 1.3}) {
    options_.friction = share * needed;
    const Rollout one = rollout(carrying_plan());
    EXPECT_NEAR(one.lift.required_force_N, 10 / share, 0.3 / share);
    EXPECT_EQ(one.forecast(one.lift), share < 1 ? Forecast::falls : Forecast::holds);
    EXPECT_EQ(one.lift.is_held(), share > 1);
    EXPECT_EQ(one.task->is_done(), share > 1);
    if (share < 1) {
      EXPECT_EQ(one.task->failure, one.lift.failure);
      EXPECT_TRUE(one.lift.failure == Failure::slip || one.lift.failure == Failure::contact_lost)
          << name_of(one.lift.failure);
      EXPECT_TRUE(std::isnan(one.task->place_error.distance_m));
    }
  }
}

TEST_F(Tasks, ReleasedInTheAirItFalls) {
  const Rollout one = rollout(carrying_plan(kBlockHeight_m, kBlockHeight_m + 0.1));
  EXPECT_TRUE(one.lift.is_held());
  EXPECT_LT(one.task->carried_error.distance_m, 0.003);
  EXPECT_EQ(one.task->failure, Failure::displaced_while_releasing);
  EXPECT_GT(one.task->place_error.distance_m, 0.09);
}

TEST_F(Tasks, WhatSupportsItAtItsPlaceMayBeHigherOrLower) {
  for (const double step : {0.03, -0.03}) {
    const double take_z = kBlockHeight_m + std::max(0.0, -step);
    Plan plan = carrying_plan(take_z, take_z + step);
    // A board of 30 mm on the table, below the place or below the block.
    plan.scene.objects.push_back(
        standing("board", Shape::box, {0.1, 0.1, 0.03}, Vec3(step > 0 ? 0.5 : 0.3, 0, 0.115)));
    const Rollout one = rollout(plan);
    EXPECT_EQ(one.task->failure, Failure::none) << name_of(one.task->failure);
    EXPECT_LT(one.task->place_error.distance_m, 0.003);
  }
}

TEST_F(Tasks, BesideTheTableItFallsPast) {
  Plan plan = carrying_plan();
  plan.scene.objects[1] = standing("table", Shape::box, {0.3, 1, 0.02}, Vec3(0.3, 0, 0.09));
  const Rollout one = rollout(plan);
  EXPECT_TRUE(one.lift.is_held());
  EXPECT_EQ(one.task->failure, Failure::displaced_while_releasing) << name_of(one.task->failure);
}

// The post reaches to the block, or to the palm above it: it pushes the block out of the hand, or
// stops the arm, whose motor has 60 N.
TEST_F(Tasks, APostInTheWayIsMet) {
  for (const double top : {0.27, 0.35}) {
    Plan plan = carrying_plan();
    plan.scene.objects.push_back(
        standing("post", Shape::box, {0.02, 0.03, top - 0.1}, Vec3(0.4, 0, 0.5 * (top + 0.1))));
    const Rollout one = rollout(plan);
    EXPECT_EQ(one.lift.is_held(), top > 0.3) << name_of(one.lift.failure);
    if (one.lift.is_held()) {
      EXPECT_EQ(one.task->failure, Failure::misplaced) << name_of(one.task->failure);
      EXPECT_GT(one.task->arm_error, 100);  // mm
    }
  }
}

TEST_F(Tasks, AHandThatDoesNotOpenKeepsIt) {
  Plan plan = carrying_plan();
  for (const Eigen::Index joint : {2, 3}) {
    plan.trajectory.position.col(joint).tail(101).setConstant(0.024);
    plan.trajectory.velocity.col(joint).tail(101).setZero();
    plan.trajectory.acceleration.col(joint).tail(101).setZero();
  }
  const Rollout one = rollout(plan);
  EXPECT_TRUE(one.lift.is_held());
  EXPECT_FALSE(one.task->is_done());
}

TEST_F(Tasks, APlanThatEndsAtTheReleaseIsJudgedInTheHand) {
  Plan plan = carrying_plan();
  Trajectory& t = plan.trajectory;
  constexpr Eigen::Index kSamples = 281;
  for (JointRows* rows : {&t.position, &t.velocity, &t.acceleration})
    *rows = JointRows(rows->topRows(kSamples));
  t.time.resize(kSamples);
  t.demonstration_time.resize(kSamples);
  t.phase.resize(kSamples);
  const PreparationResult result = prepared(plan);
  EXPECT_FALSE(result.plan.task->lets_go);
  EXPECT_EQ(result.plan.program.stand_end, result.plan.program.carry_end);
  const Rollout one = rollout(plan);
  EXPECT_TRUE(one.task->is_done()) << name_of(one.task->failure);
  EXPECT_LT(one.task->place_error.distance_m, 0.003);
}

TEST_F(Tasks, TheResultIsWrittenAndReadBack) {
  options_.rollouts = 2;
  const PlanResult result =
      simulate_plan(carrying_gripper(), carrying_plan(), "block/000", options_);
  const std::string text = result_json(result, options_, "key");
  EXPECT_NE(text.find("\"carried_error\""), std::string::npos);
  const SimulationSummary summary = summarise(result);
  EXPECT_EQ(summary.tasks, 2U);
  EXPECT_EQ(summary.tasks_done, 2U);
  EXPECT_LT(summary.place_error_m, kMaxPlaceError_m);
  const std::string rows = csv_header() + csv_rows(result);
  const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
  const std::size_t head = rows.find('\n');
  EXPECT_EQ(commas(rows), 3 * commas(rows.substr(0, head)));
}

// The engine finds one contact of a cylinder and a box: only feet let it stand.
TEST_F(Tasks, ACupStandsOnABoxHoweverTheyAreTurned) {
  const Quat turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Quat::Identity();
  SimulatedWorld world;
  const RobotModel robot = carrying_gripper_table();
  const Vec3 up = turn * Vec3::UnitZ();
  Scene scene;
  scene.objects = {standing("cup", Shape::cylinder, {0.03, 0.1}, turn * Vec3(0.3, 0, 1.0512)),
                   standing("table", Shape::box, {0.4, 0.4, 0.04}, turn * Vec3(0.3, 0, 0.98))};
  for (SceneObject& object : scene.objects) object.orientation = {turn};
  world.robot = &robot;
  world.inertias = robot_inertias(robot, 1000);
  world.servos = servos_of(carrying_gripper(), SimulateOptions());
  world.scene = &scene;
  world.target = 0;
  world.up = up;
  const Pose pose = recorded_pose(scene.objects[0], 0);
  world.support = find_support(scene, 0, {1}, pose, up);
  ASSERT_TRUE(world.support);
  EXPECT_NEAR(world.support->raise_m, 0.0012, 1e-6);
  world.feet = foot_points(scene.objects[0], pose.linear().transpose() * up);
  EXPECT_EQ(world.feet.size(), 16U);
  const physics::Model model(
      mjcf_text(world, {0.8, 0.002, 0.3, pose}, SimulateOptions(), Environment::scene));
  physics::State state(model);
  state.update_poses();
  for (int k = 0; k < 500; ++k) ASSERT_FALSE(state.step());
  EXPECT_LT((state.body(model.body("target")).translation() - pose.translation()).norm(), 2e-4);
}

TEST(Support, IsBelowAndNear) {
  Scene scene;
  scene.objects = {standing("cup", Shape::cylinder, {0.03, 0.1}, Vec3(0, 0, 0.05)),
                   standing("wall", Shape::box, {0.02, 1, 1}, Vec3(0.0405, 0, 0)),
                   standing("deep", Shape::box, {1, 1, 0.02}, Vec3(0, 0, -0.013)),
                   standing("table", Shape::box, {1, 1, 0.02}, Vec3(0, 0, -0.009))};
  const Pose pose = recorded_pose(scene.objects[0], 0);
  EXPECT_FALSE(find_support(scene, 0, {1, 2}, pose, Vec3::UnitZ()));
  const auto table = find_support(scene, 0, {1, 2, 3}, pose, Vec3::UnitZ());
  ASSERT_TRUE(table);
  EXPECT_EQ(table->object, 3);
  EXPECT_NEAR(table->raise_m, -0.001, 1e-6);
}

TEST(Forecast, SaysHoldsOrFallsOnlyBeyondItsMargin) {
  EXPECT_EQ(forecast_of(1, 1.16), Forecast::holds);
  EXPECT_EQ(forecast_of(1, 1.14), Forecast::near_limit);
  EXPECT_EQ(forecast_of(1.14, 1), Forecast::near_limit);
  EXPECT_EQ(forecast_of(1.16, 1), Forecast::falls);
  EXPECT_EQ(forecast_of(kInfinity, 8), Forecast::falls);
}

}  // namespace
}  // namespace morphe::simulate
