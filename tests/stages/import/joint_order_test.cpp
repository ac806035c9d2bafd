#include "stages/import/clips/joint_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

/// A flat right hand, keypoints in metres: x to the fingers, y to the thumb's side.
std::array<Vec3, kKeypointCount> hand() {
  std::array<Vec3, kKeypointCount> points;
  points[0] = Vec3::Zero();
  points[1] = {0.03, 0.02, 0};
  points[2] = {0.06, 0.045, 0};
  points[3] = {0.085, 0.06, 0};
  points[4] = {0.11, 0.07, 0};
  const double knuckle[] = {0.09, 0.095, 0.088, 0.08}, side[] = {0.025, 0.003, -0.018, -0.036};
  const double bones[4][3] = {
      {0.04, 0.024, 0.02}, {0.045, 0.028, 0.022}, {0.041, 0.026, 0.022}, {0.033, 0.018, 0.018}};
  for (std::size_t finger = 1; finger < kFingerCount; ++finger) {
    const std::size_t base = 1 + 4 * finger;
    points[base] = {knuckle[finger - 1], side[finger - 1], 0};
    for (std::size_t joint = 0; joint < 3; ++joint) {
      points[base + joint + 1] = points[base + joint] + Vec3(bones[finger - 1][joint], 0, 0);
    }
  }
  return points;
}

/// Two frames of that hand as an order lists it; what is no keypoint lies in the palm.
Array2D<Vec3> listed(const KeypointOrder& order) {
  const auto points = hand();
  Array2D<Vec3> joints(2, order.joints, Vec3(0.05, 0, 0));
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    if (order.joint[k] < 0) continue;
    joints(0, static_cast<std::size_t>(order.joint[k])) = points[k];
    joints(1, static_cast<std::size_t>(order.joint[k])) = points[k] + Vec3(0.3, 0.1, 1);
  }
  return joints;
}

std::string said_of(const Array2D<Vec3>& joints, const Conventions& conventions) {
  return joint_order_of(joints, "", conventions, "a.npz", "mano_right_joints").because;
}

TEST(JointOrder, EachIsToldByCountAndAnatomyInAnyUnit) {
  for (const KeypointOrder& order : keypoint_orders()) {
    Array2D<Vec3> joints = listed(order);
    for (Vec3& point : joints.values) point *= 1000;
    EXPECT_EQ(joint_order_of(joints, "", {}, "a.npz", "mano_right_joints").joint, order.joint)
        << order.name;
  }
}

TEST(JointOrder, AnotherOrderOfAsManyIsNoHand) {
  for (const KeypointOrder& order : keypoint_orders()) {
    for (const KeypointOrder& other : keypoint_orders()) {
      if (other.joints != order.joints || other.joint == order.joint) continue;
      EXPECT_LT(hand_similarity(listed(order), other.joint), 0.8) << order.name << other.name;
    }
    EXPECT_GT(hand_similarity(listed(order), order.joint), 0.95) << order.name;
  }
}

TEST(JointOrder, WhatWasAskedForComesFirst) {
  Conventions conventions;
  conventions.joint_order = "mano";
  EXPECT_EQ(said_of(listed(*keypoint_order("openpose")), conventions),
            "joint order mano, as given");
  conventions.joint_order = "openxr";
  EXPECT_THAT([&] { said_of(listed(*keypoint_order("openpose")), conventions); },
              testing::ThrowsMessage<InputError>(testing::StrEq(
                  "a.npz: mano_right_joints: has 21 joints, but the order openxr has 26")));
}

TEST(JointOrder, ThatOfTheFileIsComparedWithTheBones) {
  for (const KeypointOrder& order : keypoint_orders()) {
    EXPECT_EQ(joint_order_of(listed(order), std::string(order.name), {}, "a.npz", "j").joint,
              order.joint);
    for (const KeypointOrder& stated : keypoint_orders()) {
      if (stated.joints != order.joints || stated.joint == order.joint) continue;
      try {
        joint_order_of(listed(order), std::string(stated.name), {}, "a.npz", "j");
        ADD_FAILURE() << order.name << " as " << stated.name;
      } catch (const UnresolvedConvention& asked) {
        EXPECT_EQ(asked.key, "joint_order");
        EXPECT_EQ(keypoint_order(asked.likely_value)->joint, order.joint);
      }
    }
  }
}

TEST(JointOrder, NoHandIsAskedFor) {
  try {
    said_of(Array2D<Vec3>(2, 21, Vec3(0.1, 0, 0)), {});
    FAIL();
  } catch (const UnresolvedConvention& missing) {
    EXPECT_EQ(missing.key, "joint_order");
    EXPECT_FALSE(missing.likely_value.empty());
  }
}

TEST(JointOrder, SegmentsStandAtTheRootOfTheirBones) {
  std::vector<std::string> unknown;
  const JointOrder order = order_by_names(
      {"palm", "RightHandWrist", "ThumbMetacarpal", "thumb_proximal", "thumb_distal", "thumb_tip",
       "indexFingerMetacarpal", "right_index_proximal", "index_mid", "Pinky_Distal", "little_tip"},
      unknown);
  EXPECT_EQ(order.joint[0], 1);
  EXPECT_EQ((std::vector<int>(order.joint.begin() + 1, order.joint.begin() + 6)),
            (std::vector<int>{2, 3, 4, 5, 7}));
  EXPECT_EQ(order.joint[19], 9);
  EXPECT_EQ(order.joint[20], 10);
  EXPECT_EQ(unknown, (std::vector<std::string>{"index_mid"}));
  EXPECT_EQ(order_by_names({"thumb_proximal", "thumb_intermediate"}, unknown).joint[1], 0);
}

}  // namespace
}  // namespace morphe::imports
