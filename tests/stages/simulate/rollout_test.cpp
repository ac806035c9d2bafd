#include "stages/simulate/rollout.hpp"

#include <gtest/gtest.h>

#include "pipeline/parallel/for_each.hpp"
#include "pipeline/physics/model.hpp"
#include "stages/simulate/results.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

class Rollouts : public testing::Test {
 protected:
  void SetUp() override {
    if (physics::engine().empty()) GTEST_SKIP() << "built without MuJoCo";
  }

  /// Of the gripper's plan, nothing varied but what the options say.
  Rollout rollout(const SimulateOptions& options, bool directions = false,
                  const Vec3& shift = Vec3::Zero()) const {
    const Prepared prepared = prepare(gripper(), plan_, options);
    EXPECT_EQ(prepared.unfit, Unfit::none) << prepared.detail;
    Variation variation = variation_of(prepared.plan, options, "cup/000", 0);
    variation.base_from_target.translation() += shift;
    return roll_out(prepared.plan, variation, options, directions);
  }

  Plan plan_ = cup_plan();
};

TEST_F(Rollouts, AGripperLiftsACupAndHoldsIt) {
  const Rollout one = rollout(SimulateOptions());
  EXPECT_EQ(one.lift.failure, Failure::none) << name_of(one.lift.failure);
  EXPECT_LT(one.arm_error, 1);     // mm
  EXPECT_LT(one.hand_error, 0.5);  // degrees
  EXPECT_GT(one.contact_s, 0.5);   // the trajectory ends 10 mm from it
  EXPECT_LT(one.contact_s, 1.2);
  EXPECT_LT(one.pushed.distance_m, 0.003);
  EXPECT_LT(one.lift.creep.distance_m, 0.001);
  EXPECT_GE(one.lift.largest.distance_m, one.lift.creep.distance_m);
  EXPECT_GT(one.torque_share, 0.5);
}

TEST_F(Rollouts, GlueAlwaysLiftsAndIceNever) {
  SimulateOptions options;
  options.friction = 10;
  options.torsion_m = 0.02;
  EXPECT_TRUE(rollout(options).lift.held());
  options.friction = 0.01;
  options.torsion_m = 0.0001;
  EXPECT_FALSE(rollout(options).lift.held());
}

// Two fingers of 8 N hold 2 · 8 μ: at 0.3 kg μ 0.184.
TEST_F(Rollouts, TheFrictionThatIsNeededTellsHoldFromSlip) {
  SimulateOptions options;
  options.torsion_m = 0.02;
  options.friction = 0.22;
  EXPECT_TRUE(rollout(options).lift.held());
  options.friction = 0.15;
  const Holding fell = rollout(options).lift;
  EXPECT_TRUE(fell.failure == Failure::slip || fell.failure == Failure::lost)
      << name_of(fell.failure);
}

TEST_F(Rollouts, SixDirectionsArePutOnApart) {
  SimulateOptions options;
  options.mass_kg = 0.05;
  const Rollout one = rollout(options, true);
  ASSERT_EQ(one.directions.size(), 6U);
  for (const Holding& holding : one.directions)
    EXPECT_EQ(holding.failure, Failure::none) << name_of(holding.failure);
  options.mass_kg = 3;  // twice what 8 N bear at the most: 2 · 0.8 · 8 N
  for (const Holding& holding : rollout(options, true).directions) EXPECT_FALSE(holding.held());
}

TEST_F(Rollouts, ATargetThatIsElsewhereIsNotTakenHoldOf) {
  EXPECT_EQ(rollout(SimulateOptions(), false, Vec3(0.3, 0, 0)).lift.failure, Failure::no_contact);
  const Failure beside = rollout(SimulateOptions(), false, Vec3(0, 0.025, 0)).lift.failure;
  EXPECT_EQ(beside, Failure::pushed) << name_of(beside);
}

TEST_F(Rollouts, HalfTheStepAndTheOtherIntegratorSayTheSame) {
  for (const double friction : {0.12, 0.3}) {
    SimulateOptions options;
    options.torsion_m = 0.02;
    options.friction = friction;
    const bool held = rollout(options).lift.held();
    EXPECT_EQ(held, friction > 0.2);
    options.step_s = 0.001;
    EXPECT_EQ(rollout(options).lift.held(), held);
    options.euler = true;
    EXPECT_EQ(rollout(options).lift.held(), held);
  }
}

TEST_F(Rollouts, AModelThatTheEngineRefusesIsAFailureWithItsWords) {
  const Prepared prepared = prepare(gripper(), plan_, SimulateOptions());
  Variation variation = variation_of(prepared.plan, SimulateOptions(), "cup/000", 0);
  variation.mass_kg = kNotSeen;
  const Rollout one = roll_out(prepared.plan, variation, SimulateOptions(), false);
  EXPECT_EQ(one.lift.failure, Failure::engine);
  EXPECT_NE(one.lift.detail, "");
}

TEST_F(Rollouts, AnEnsembleHasTheSameBytesOnAnyNumberOfThreads) {
  SimulateOptions options;
  options.ensemble = 4;
  const auto text = [&](int jobs) {
    std::string all;
    parallel::for_each<std::string>(
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
