#include "stages/repair/bridge_collisions.hpp"

#include <gtest/gtest.h>

#include <string>

namespace morphe::repair {
namespace {

/// A palm with two fingers of two joints each, and a wrist joint that moves all of it. The palm's
/// frame is a fixed child of the hand's, beside the fingers.
RobotModel two_fingers() {
  RobotModel robot;
  robot.joint_names = {"wrist", "a1", "a2", "b1", "b2"};
  const auto add = [&](const std::string& name, int parent, int joint) {
    RobotModel::Frame frame;
    frame.name = name;
    frame.parent = parent;
    frame.joint = joint;
    robot.frames.push_back(frame);
    robot.capsules.push_back({name, static_cast<int>(robot.frames.size()) - 1, Vec3(0, 0, 0),
                              Vec3(0.02, 0, 0), 0.005, false});
  };
  add("hand", -1, 0);
  add("palm", 0, -1);
  add("a_first", 0, 1);
  add("a_second", 2, 2);
  add("b_first", 0, 3);
  add("b_second", 4, 4);
  robot.palm_frame = 1;
  return robot;
}

/// 101 samples in 1 s; joint j follows (j + 1) t^2, so that no straight line lies on the path.
JointPath parabolas() {
  JointPath path;
  path.position.resize(101, 5);
  for (int k = 0; k <= 100; ++k) {
    path.demonstration_time.push_back(0.01 * k);
    for (int j = 0; j < 5; ++j) path.position(k, j) = (j + 1) * 1e-4 * k * k;
  }
  path.origin.assign(101, SampleOrigin::mapped);
  return path;
}

Finding collision_of(const std::string& first, const std::string& second, double begin_s,
                     double end_s) {
  return {begin_s, end_s, Cause::self_collision, first, second, 0.001};
}

TEST(BridgeCollisions, TheFingerGoesStraightOverItsCollisionAndTheOtherFingerStays) {
  const JointPath path = parabolas();
  const CheckedPath checked{path, {collision_of("palm", "a_second", 0.4, 0.5)}};
  const JointPath bridged = bridge_collisions(two_fingers(), checked, 0.1001);
  // Samples 30 to 60 are bridged, between samples 29 and 61.
  for (int k = 0; k <= 100; ++k) {
    const bool inside = k >= 30 && k <= 60;
    EXPECT_EQ(bridged.origin[k], inside ? SampleOrigin::re_solved : SampleOrigin::mapped) << k;
    for (const int j : {0, 3, 4}) EXPECT_EQ(bridged.position(k, j), path.position(k, j));
    for (const int j : {1, 2}) {
      const double from = (j + 1) * 1e-4 * 29 * 29, to = (j + 1) * 1e-4 * 61 * 61;
      const double line = from + (k - 29) / 32.0 * (to - from);
      EXPECT_NEAR(bridged.position(k, j), inside ? line : path.position(k, j), 1e-12) << k;
    }
  }
}

TEST(BridgeCollisions, BothFingersOfACollisionAreBridgedAndBridgesThatOverlapAreOne) {
  const JointPath path = parabolas();
  const CheckedPath checked{path,
                            {collision_of("b_first", "a_second", 0.50, 0.55),
                             collision_of("a_second", "palm", 0.42, 0.48)}};
  const JointPath bridged = bridge_collisions(two_fingers(), checked, 0.0201);
  EXPECT_NEAR(bridged.position(45, 1) - bridged.position(44, 1),
              bridged.position(54, 1) - bridged.position(53, 1), 1e-12)
      << "one line over both";
  EXPECT_EQ(bridged.position(45, 3), path.position(45, 3));
  EXPECT_GT(bridged.position(52, 3), path.position(52, 3)) << "a chord of a parabola is above it";
}

TEST(BridgeCollisions, AtAnEndTheFingerRestsInTheNearestFreePosture) {
  const JointPath path = parabolas();
  const CheckedPath checked{
      path, {collision_of("palm", "b_first", 0.9, 1.0), collision_of("palm", "a_first", 0.0, 0.1)}};
  const JointPath bridged = bridge_collisions(two_fingers(), checked, 0.0501);
  for (int k = 85; k <= 100; ++k) EXPECT_EQ(bridged.position(k, 4), path.position(84, 4));
  for (int k = 0; k <= 15; ++k) EXPECT_EQ(bridged.position(k, 2), path.position(16, 2));
}

TEST(BridgeCollisions, WhatNoBridgeCanSpanIsLeft) {
  const JointPath path = parabolas();
  const std::vector<Finding> left{
      collision_of("palm", "a_first", 0.0, 1.0),            // all of the path
      collision_of("palm", "hand", 0.4, 0.5),               // no finger
      {0.4, 0.5, Cause::tracking, "a_second", "", 0.001}};  // no collision
  const JointPath bridged = bridge_collisions(two_fingers(), {path, left}, 0.1);
  EXPECT_EQ(bridged.position, path.position);
  EXPECT_EQ(bridged.origin, path.origin);
}

}  // namespace
}  // namespace morphe::repair
