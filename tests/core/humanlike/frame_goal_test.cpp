#include "core/humanlike/frame_goal.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace morphe::humanlike {
namespace {

struct Counter {
  int points = 0, rotations = 0, numbers = 0;
  void operator()(const Vec3&) { ++points; }
  void operator()(const Quat&) { ++rotations; }
  void operator()(double) { ++numbers; }
};

TEST(FrameGoal, EachQuantityIsVisitedOnce) {
  FrameGoal goal;
  goal.tip_position.resize(3);
  goal.tip_orientation.resize(3);
  goal.tip_to_pad_share.resize(3);
  goal.pad_normal.resize(3);
  goal.closes_by_itself.resize(3);
  goal.interpolated_finger_joint.resize(4);
  goal.chain.resize(7);
  goal.angles.setZero(20);
  Counter counter;
  const FrameGoal& constant = goal;
  for_each_quantity(constant, [&](const auto& quantity) { counter(quantity); });
  // Tips, pads, shoulder, elbow and wrist, middle joints, those of the curve, joints of the arm.
  EXPECT_EQ(counter.points, 3 + 3 + 3 + static_cast<int>(kFingerCount) + 4 + 7);
  EXPECT_EQ(counter.rotations, 3 + 1);
  EXPECT_EQ(counter.numbers, 3 + 20);
}

TEST(FrameGoal, AQuantityCanBeChanged) {
  FrameGoal goal;
  goal.angles.setZero(2);
  for_each_quantity(goal, [](auto& quantity) {
    if constexpr (std::is_same_v<decltype(quantity), double&>) quantity = 2;
    if constexpr (std::is_same_v<decltype(quantity), Vec3&>) quantity = Vec3::Ones();
  });
  EXPECT_EQ(goal.angles, JointVector::Constant(2, 2));
  EXPECT_EQ(goal.elbow, Vec3::Ones());
  EXPECT_EQ(goal.finger_joint.back(), Vec3::Ones());
  EXPECT_EQ(goal.hand_scale, 1);
}

}  // namespace
}  // namespace morphe::humanlike
