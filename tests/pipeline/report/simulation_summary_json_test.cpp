#include "pipeline/report/simulation_summary_json.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/motion/input_error.hpp"
#include "core/store/fingerprint.hpp"
#include "stages/simulate/results.hpp"

namespace morphe::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class PhysicsJson : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / "morphe_physics_json_test";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    plan_.demonstration = "a";
    plan_.movement.index = 2;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static simulate::Rollout rollout(simulate::Failure failure, double droop_m,
                                   double required_force_N, double torque) {
    simulate::Rollout rollout;
    rollout.variation = {0.8, 0.002, 0.3, Pose::Identity()};
    rollout.torque_ratio = torque;
    rollout.commanded_force_N = 8;
    rollout.lift.failure = failure;
    rollout.lift.droop.distance_m = droop_m;
    rollout.lift.required_force_N = required_force_N;
    rollout.load_directions.resize(2);
    rollout.load_directions[0].failure = simulate::Failure::pivot;
    return rollout;
  }
  simulate::PlanResult result() const {
    using simulate::Failure;
    simulate::PlanResult result;
    result.plan = "a/002";
    result.plan_sha256 = store::fingerprint(robot_, plan_);
    result.contact_source = simulate::ContactSource::planned;
    result.rollouts = {rollout(Failure::none, 0.001, 4, 0.5), rollout(Failure::none, 0.003, 6, 0.9),
                       rollout(Failure::none, 0.002, 5, 0.6),
                       rollout(Failure::slip, 0.02, kInfinity, 0.7),
                       rollout(Failure::displaced_while_closing, 0, 4.5, 0.7)};
    return result;
  }
  Json shown(const simulate::PlanResult& result) {
    return shown(simulate::result_json(result, simulate::SimulateOptions(), "key"));
  }
  Json shown(const std::string& text) {
    std::ofstream(folder_ / "a_002.json") << text;
    return simulation_summary_json({folder_ / "not there", folder_}, robot_, plan_, notes_);
  }

  fs::path folder_;
  RobotModel robot_;
  Plan plan_;
  std::vector<std::string> notes_;
};

TEST_F(PhysicsJson, CountsAndMediansOfWhatHeld) {
  const Json json = shown(result());
  EXPECT_EQ(json["held"], 3);
  EXPECT_EQ(json["rollouts"], 5);
  EXPECT_EQ(json["failures"], Json({{"displaced_while_closing", 1}, {"slip", 1}}));
  EXPECT_EQ(json["load_directions"], 10);
  EXPECT_EQ(json["load_directions_held"], 5);
  EXPECT_EQ(json["direction_failures"], Json({{"pivot", 5}}));
  EXPECT_DOUBLE_EQ(json["droop_m"].get<double>(), 0.002);
  EXPECT_DOUBLE_EQ(json["torque_ratio"].get<double>(), 0.9);
  EXPECT_DOUBLE_EQ(json["required_force_N"].get<double>(), 5);
  EXPECT_TRUE(notes_.empty());
}

TEST_F(PhysicsJson, NothingOfAnotherPlan) {
  const simulate::PlanResult of_this = result();
  plan_.task = "another";
  EXPECT_TRUE(shown(of_this).is_null());
  ASSERT_EQ(notes_.size(), 1U);
  EXPECT_EQ(notes_[0].substr(0, 6), "a/002:");
  plan_.movement.index = 3;  // nothing is there of it
  EXPECT_TRUE(simulation_summary_json({folder_}, robot_, plan_, notes_).is_null());
  EXPECT_EQ(notes_.size(), 1U);
}

TEST_F(PhysicsJson, WhatIsNoResultIsRefusedByItsName) {
  const std::string whole = simulate::result_json(result(), simulate::SimulateOptions(), "key");
  Json lacking = Json::parse(whole), newer = lacking;
  lacking["rollouts"][1].erase("lift");
  newer["version"] = newer["version"].get<int>() + 1;
  for (const std::string& broken :
       {std::string("3"), std::string("{}"), whole.substr(0, whole.size() / 2), lacking.dump(),
        newer.dump()}) {
    try {
      shown(broken);
      ADD_FAILURE() << broken;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind((folder_ / "a_002.json").string(), 0), 0U);
    }
  }
}

}  // namespace
}  // namespace morphe::report
