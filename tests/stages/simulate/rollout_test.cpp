#include "stages/simulate/rollout.hpp"

#include <gtest/gtest.h>

#include "core/math/random_stream.hpp"
#include "core/parallel/for_each.hpp"
#include "core/physics/model.hpp"
#include "core/physics/state.hpp"
#include "stages/simulate/results.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

class Rollouts : public testing::Test {
 protected:
  void SetUp() override {
    if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  }

  /// Of the gripper's plan, nothing varied but what the options say.
  Rollout rollout(const SimulateOptions& options, bool directions = false,
                  const Vec3& shift = Vec3::Zero()) const {
    const PreparationResult prepared = prepare(gripper(), plan_, options);
    EXPECT_EQ(prepared.skip_reason, SkipReason::none) << prepared.detail;
    Variation variation = variation_of(prepared.plan, options, "cup/000", 0);
    variation.base_from_target.translation() += shift;
    return roll_out(prepared.plan, variation, options, directions);
  }

  Plan plan_ = cup_plan();
};

TEST_F(Rollouts, AGripperLiftsACupAndHoldsIt) {
  const Rollout one = rollout(SimulateOptions());
  EXPECT_EQ(one.lift.failure, Failure::none) << name_of(one.lift.failure);
  EXPECT_LT(one.arm_error, 0.05);   // mm
  EXPECT_LT(one.hand_error, 0.05);  // degrees
  EXPECT_GT(one.contact_s, 0.5);    // the trajectory ends 10 mm from it
  EXPECT_LT(one.contact_s, 1.2);
  EXPECT_LT(one.pregrasp_displacement.distance_m, 0.003);
  EXPECT_LT(one.lift.drift.distance_m, 0.001);
  EXPECT_GE(one.lift.in_hand_displacement.distance_m, one.lift.drift.distance_m);
  EXPECT_GT(one.torque_ratio, 0.5);
}

TEST_F(Rollouts, GlueAlwaysLiftsAndIceNever) {
  SimulateOptions options;
  options.friction = 10;
  options.torsional_friction_m = 0.02;
  EXPECT_TRUE(rollout(options).lift.is_held());
  options.friction = 0.01;
  options.torsional_friction_m = 0.0001;
  EXPECT_FALSE(rollout(options).lift.is_held());
}

// Two fingers of 8 N hold 2 · 8 μ: at 0.3 kg μ 0.184.
TEST_F(Rollouts, TheFrictionThatIsNeededTellsHoldFromSlip) {
  SimulateOptions options;
  options.torsional_friction_m = 0.02;
  options.friction = 0.22;
  EXPECT_TRUE(rollout(options).lift.is_held());
  options.friction = 0.15;
  const HoldResult fell = rollout(options).lift;
  EXPECT_TRUE(fell.failure == Failure::slip || fell.failure == Failure::contact_lost)
      << name_of(fell.failure);
}

TEST_F(Rollouts, SixDirectionsArePutOnApart) {
  SimulateOptions options;
  options.mass_kg = 0.05;
  const Rollout one = rollout(options, true);
  ASSERT_EQ(one.load_directions.size(), 6U);
  for (const HoldResult& holding : one.load_directions)
    EXPECT_EQ(holding.failure, Failure::none) << name_of(holding.failure);
  options.mass_kg = 3;  // twice what 8 N bear at the most: 2 · 0.8 · 8 N
  for (const HoldResult& holding : rollout(options, true).load_directions)
    EXPECT_FALSE(holding.is_held());
}

TEST_F(Rollouts, ATargetThatIsElsewhereIsNotTakenHoldOf) {
  EXPECT_EQ(rollout(SimulateOptions(), false, Vec3(0.3, 0, 0)).lift.failure, Failure::no_touch);
  const Failure beside = rollout(SimulateOptions(), false, Vec3(0, 0.025, 0)).lift.failure;
  EXPECT_EQ(beside, Failure::displaced_before_closing) << name_of(beside);
}

TEST_F(Rollouts, TheSqueezeThatIsSentIsTheOneThatPresses) {
  add_squeeze(plan_);
  const Rollout one = rollout(SimulateOptions());
  EXPECT_TRUE(one.lift.is_held()) << name_of(one.lift.failure);
  ASSERT_EQ(one.measured_force_N.size(), 2U);
  EXPECT_NEAR(one.measured_force_N[0], 5, 0.3);
  EXPECT_NEAR(one.measured_force_N[1], 5, 0.3);
}

// Two fingers of N newtons bear 2 mu N: needed are M (g + 0.577) / (2 mu), for the lift's largest
// acceleration.
TEST_F(Rollouts, ThePredictedForcesTellHoldFromFall) {
  add_squeeze(plan_);
  SimulateOptions options;
  options.torsional_friction_m = 0.02;
  for (const double friction : {0.1, 0.25, 0.5, 1.0}) {
    for (const double mass : {0.1, 0.3, 0.9}) {
      options.friction = friction;
      options.mass_kg = mass;
      const Rollout one = rollout(options);
      const double needed = mass * (9.81 + 0.577) / (2 * friction);
      EXPECT_NEAR(one.lift.required_force_N, needed, 0.02 * needed);
      EXPECT_EQ(one.commanded_force_N, 5);
      EXPECT_NEAR(one.required_force_gravity_N, mass * 9.81 / (2 * friction), 0.02 * needed);
      EXPECT_GE(one.required_force_worst_N, 0.98 * one.required_force_gravity_N);
      const Forecast forecast = one.forecast(one.lift);
      EXPECT_EQ(forecast == Forecast::near_limit, std::abs(std::log(5 / needed)) < std::log(1.15));
      if (forecast == Forecast::near_limit) continue;
      EXPECT_EQ(forecast == Forecast::holds, one.lift.is_held()) << friction << " " << mass;
    }
  }
}

TEST_F(Rollouts, ATrajectoryIsFollowedByAHeavyHandToo) {
  SimulateOptions options;
  options.density = 8000;
  const Rollout one = rollout(options);
  EXPECT_LT(one.arm_error, 0.05);   // mm
  EXPECT_LT(one.hand_error, 0.05);  // degrees
}

TEST_F(Rollouts, WhoIsFarFromTheTrajectoryFailsByThat) {
  SimulateOptions options;
  options.servos["thumb"].torque_limit = options.servos["index"].torque_limit = 1e-4;
  options.servos["thumb"].damping = options.servos["index"].damping = 5;
  EXPECT_EQ(rollout(options).lift.failure, Failure::tracking_error);
}

TEST_F(Rollouts, AHandWithoutAnArmIsLiftedByItsBase) {
  RobotModel table = gripper_table();
  table.joint_names = {"thumb", "index"};
  for (JointVector* limits :
       {&table.lower, &table.upper, &table.velocity, &table.acceleration, &table.jerk})
    *limits = JointVector(limits->tail(2));
  for (RobotModel::Frame& frame : table.frames) frame.joint -= 1;
  table.frames[0].prismatic = false;
  Trajectory& t = plan_.trajectory;
  for (JointRows* rows : {&t.position, &t.velocity, &t.acceleration})
    *rows = JointRows(rows->rightCols(2));
  plan_.grasp.grasp_posture = plan_.grasp.grasp_posture.tail(2).eval();
  const robot::Robot hand(table);
  ASSERT_TRUE(hand.arm_joints.empty());
  SimulateOptions options;
  const PreparationResult prepared = prepare(hand, plan_, options);
  ASSERT_EQ(prepared.skip_reason, SkipReason::none) << prepared.detail;
  const auto of = [&](double friction) {
    options.friction = friction;
    return roll_out(prepared.plan, variation_of(prepared.plan, options, "cup/000", 0), options,
                    false);
  };
  const Rollout held = of(0.8), fell = of(0.05);
  EXPECT_TRUE(held.lift.is_held()) << name_of(held.lift.failure);
  EXPECT_GT(fell.lift.in_hand_displacement.distance_m, 0.02);
  EXPECT_FALSE(fell.lift.is_held());
}

// MuJoCo finds no contact between a plane and a cylinder that is upright on it to rounding.
TEST_F(Rollouts, ACupStandsHoweverTheBaseIsTurned) {
  math::RandomStream random(3, "bases");
  for (int trial = 0; trial < 20; ++trial) {
    SimulatedWorld world;
    RobotModel robot = gripper_table();
    Scene scene;
    const Quat turn = random.rotation();
    scene.objects = {standing("cup", Shape::cylinder, {0.03, 0.1}, turn * Vec3(0.3, 0, 1))};
    scene.objects[0].orientation = {turn};
    world.robot = &robot;
    world.inertias = robot_inertias(robot, 1000);
    world.servos = servos_of(gripper(), SimulateOptions());
    world.scene = &scene;
    world.target = 0;
    world.up = turn * Vec3::UnitZ();
    Variation variation{0.8, 0.002, 0.3, recorded_pose(scene.objects[0], 0)};
    const physics::Model model(mjcf_text(world, variation, SimulateOptions(), Environment::scene));
    physics::State state(model);
    const int cup = model.body("target");
    state.update_poses();
    for (int k = 0; k < 200; ++k) ASSERT_FALSE(state.step());
    EXPECT_LT((state.body(cup).translation() - scene.objects[0].position[0]).norm(), 1e-4) << trial;
  }
}

TEST_F(Rollouts, HalfTheStepAndTheOtherIntegratorSayTheSame) {
  for (const double friction : {0.12, 0.3}) {
    SimulateOptions options;
    options.torsional_friction_m = 0.02;
    options.friction = friction;
    const bool held = rollout(options).lift.is_held();
    EXPECT_EQ(held, friction > 0.2);
    options.step_s = 0.001;
    EXPECT_EQ(rollout(options).lift.is_held(), held);
    options.euler = true;
    EXPECT_EQ(rollout(options).lift.is_held(), held);
  }
}

TEST_F(Rollouts, AModelThatTheEngineRefusesIsAFailureWithItsWords) {
  const PreparationResult prepared = prepare(gripper(), plan_, SimulateOptions());
  Variation variation = variation_of(prepared.plan, SimulateOptions(), "cup/000", 0);
  variation.mass_kg = kUnknown;
  const Rollout one = roll_out(prepared.plan, variation, SimulateOptions(), false);
  EXPECT_EQ(one.lift.failure, Failure::engine_error);
  EXPECT_NE(one.lift.detail, "");
}

TEST_F(Rollouts, AnEnsembleHasTheSameBytesOnAnyNumberOfThreads) {
  SimulateOptions options;
  options.rollouts = 4;
  const auto text = [&](int jobs) {
    std::string all;
    parallel::ordered_for_each<std::string>(
        1, jobs,
        [&](std::uint64_t) {
          return result_json(simulate_plan(gripper(), plan_, "cup/000", options), options, "key");
        },
        [&](const std::string& one) { all += one; });
    return all;
  };
  EXPECT_EQ(text(1), text(4));
}

}  // namespace
}  // namespace morphe::simulate
