#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <thread>

#include "core/physics/state.hpp"
#include "tests/core/physics/pinched_block.hpp"

namespace morphe::physics {
namespace {

using testing::HasSubstr;
using testing::Optional;
using testing::StrEq;
using testing::Throws;
using testing::ThrowsMessage;

class Physics : public testing::Test {
 protected:
  void SetUp() override {
    if (engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  }
};

/// How far the block is below its place after some seconds, and how far it has turned about x.
struct Fallen {
  double below_m = 0, turned_deg = 0;
};
Fallen fallen(double friction, double torsion_m, double force_N, double aside = 0,
              double seconds = 1) {
  const Model model(pinched_block(friction, torsion_m, aside));
  State state(model);
  for (const char* pad : {"left", "right"}) state.set_control(model.actuator(pad), force_N);
  const int block = model.body("block");
  for (double s = 0; s < seconds; s += 0.002) {
    EXPECT_EQ(state.step(), std::nullopt);
  }
  const Pose pose = state.body(block);
  return {-pose.translation().z(),
          angle_between(Quat(pose.linear()), Quat::Identity()) / kRadPerDegree};
}

TEST_F(Physics, CoulombHoldsJustAboveTheFrictionItAsksForAndNotBelow) {
  EXPECT_LT(fallen(0.17, 0.002, 3).below_m, 0.001);
  EXPECT_GT(fallen(0.16, 0.002, 3).below_m, 0.01);
}

// 20 mm beside the middle the weight turns with 0.1 · 9.81 · 0.02 = 0.0196 N m, which two pads of
// 3.5 mm torsion hold from 2.8 N on.
TEST_F(Physics, TorsionHoldsAWeightThatHangsAside) {
  EXPECT_LT(fallen(0.8, 0.0035, 3.0, 0.02).turned_deg, 1);
  EXPECT_GT(fallen(0.8, 0.0035, 2.5, 0.02).turned_deg, 5);
}

TEST_F(Physics, AModelThatIsNoneIsAnErrorThatNamesTheLine) {
  EXPECT_THAT(
      [] { Model("<mujoco>\n<worldbody>\n<geom type=\"square\"/>\n</worldbody></mujoco>"); },
      ThrowsMessage<EngineError>(HasSubstr("line 3")));
  EXPECT_THAT([] { Model("no xml"); }, ThrowsMessage<EngineError>(HasSubstr("XML parse error")));
  EXPECT_THAT([] { Model(""); }, ThrowsMessage<EngineError>(HasSubstr("EMPTY_DOCUMENT")));
}

TEST_F(Physics, ANumberThatIsNoneInAModelIsAnError) {
  EXPECT_THAT(
      [] {
        Model(
            "<mujoco><worldbody><body pos=\"0 0 nan\"><joint type=\"slide\"/>"
            "<geom size=\"1\"/></body></worldbody></mujoco>");
      },
      ThrowsMessage<EngineError>(HasSubstr("contains a 'NaN'")));
}

TEST_F(Physics, WhatHasNoNameIsAnError) {
  const Model model(pinched_block(0.8, 0.002));
  EXPECT_THAT([&] { model.body("cup"); },
              ThrowsMessage<EngineError>(StrEq("the model has no element 'cup'")));
  EXPECT_THAT([&] { model.joint("left2"); },
              ThrowsMessage<EngineError>(StrEq("the model has no element 'left2'")));
}

// Left to itself the engine goes back to its start with the block in its place.
TEST_F(Physics, AStateOfNumbersThatAreNoneIsNoticed) {
  const Model model(pinched_block(0.8, 0.002));
  for (const double bad : {kUnknown, 1e30}) {
    State state(model);
    EXPECT_EQ(state.step(), std::nullopt);
    state.set_joint(model.joint("left"), bad);
    EXPECT_THAT(state.step(), Optional(HasSubstr("unstable")));
  }
  State state(model);
  state.set_control(model.actuator("left"), kUnknown);
  EXPECT_THAT(state.step(), Optional(HasSubstr("in CTRL at ACTUATOR 0")));
}

/// A block whose model asks for more than these sizes leave.
std::string cramped_block(const std::string& sizes) {
  std::string text = pinched_block(0.8, 0.002);
  return text.insert(text.find("<compiler"), "<size " + sizes + "/>");
}

/// Warnings and errors go there where nobody takes them.
TEST_F(Physics, NothingIsWrittenBesideTheProgram) {
  const Model model(pinched_block(0.8, 0.002));
  State state(model);
  state.set_control(model.actuator("left"), kUnknown);
  EXPECT_TRUE(state.step().has_value());
  EXPECT_THAT([] { Model(cramped_block("nstack=\"10\"")); }, Throws<EngineError>());
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST_F(Physics, AnErrorInsideTheEngineEndsTheCallAndNothingElse) {
  // A stack too small for the model: the engine gives up inside a step, or as it loads.
  EXPECT_THAT(
      [] {
        const Model model(cramped_block("nstack=\"10\""));
        State state(model);
        for (int k = 0; k < 100; ++k) state.step();
      },
      ThrowsMessage<EngineError>(HasSubstr("Stack overflow")));
  EXPECT_LT(fallen(0.8, 0.002, 3).below_m, 0.001);  // and the next one runs as before
}

TEST_F(Physics, ContactsThatHaveNoPlaceAreNoticed) {
  const Model model(cramped_block("njmax=\"3\" nconmax=\"1\""));
  State state(model);
  for (const char* pad : {"left", "right"}) state.set_control(model.actuator(pad), 3);
  std::optional<std::string> wrong;
  for (int k = 0; k < 500 && !wrong; ++k) wrong = state.step();
  EXPECT_THAT(wrong, Optional(HasSubstr("contact buffer is full. Increase nconmax above 1")));
}

/// Heights of the block while it slips, bit for bit.
std::vector<double> heights(const Model& model, State& state, int steps) {
  std::vector<double> all;
  for (int k = 0; k < steps; ++k) {
    EXPECT_EQ(state.step(), std::nullopt);
    all.push_back(state.body(model.body("block")).translation().z());
  }
  return all;
}

State pinched(const Model& model) {
  State state(model);
  for (const char* pad : {"left", "right"}) state.set_control(model.actuator(pad), 3);
  return state;
}

TEST_F(Physics, AStateGoesOnFromASnapshotBitForBit) {
  const Model model(pinched_block(0.17, 0.002));
  State state = pinched(model);
  heights(model, state, 200);
  const Snapshot taken = state.snapshot();
  const std::vector<double> went_on = heights(model, state, 200);
  State other(model);
  other.restore(taken);
  EXPECT_EQ(heights(model, other, 200), went_on);
}

TEST_F(Physics, ThreadsDoNotSeeEachOther) {
  const Model model(pinched_block(0.16, 0.002));
  State alone = pinched(model);
  const std::vector<double> expected = heights(model, alone, 300);
  std::vector<std::vector<double>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& one : found) {
    threads.emplace_back([&] {
      State state = pinched(model);
      one = heights(model, state, 300);
      EXPECT_THAT([] { Model("no xml"); },
                  ThrowsMessage<EngineError>(HasSubstr("XML parse error")));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& one : found) EXPECT_EQ(one, expected);
}

TEST_F(Physics, TouchesAreSeenWithTheirForces) {
  const Model model(pinched_block(0.8, 0.002));
  State state = pinched(model);
  heights(model, state, 500);
  std::vector<GeomContact> touches;
  state.contacts(touches);
  ASSERT_EQ(touches.size(), 2U);
  for (const GeomContact& touch : touches) {
    EXPECT_NEAR(touch.force, 3, 0.05);
    EXPECT_NEAR(std::abs(touch.normal.x()), 1, 1e-3);
    EXPECT_NEAR(std::abs(touch.point.x()), 0.02, 1e-3);
  }
}

}  // namespace
}  // namespace morphe::physics
