#include "core/robot/standing.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace morphe::robot {
namespace {

/// A frame of the base with a name, at a place.
RobotModel::Frame frame_at(const char* name, const Vec3& place) {
  RobotModel::Frame frame;
  frame.name = name;
  frame.transform.translation() = place;
  return frame;
}

/// A robot whose frames are on the base, except the last one, the palm, which moves with the first,
/// the shoulder.
RobotModel robot_of(const std::vector<RobotModel::Frame>& frames) {
  RobotModel robot;
  robot.joint_names = {"shoulder"};
  robot.frames = frames;
  robot.frames.front().joint = 0;
  robot.frames.back().parent = 0;
  robot.shoulder_frame = 0;
  robot.palm_frame = static_cast<int>(frames.size()) - 1;
  return robot;
}

/// A robot with legs, whose up and forward in its base frame are the axes of `base_from_body`.
RobotModel legged(const Eigen::Matrix3d& base_from_body) {
  const auto at = [&](double x, double y, double z) -> Vec3 {
    return base_from_body * Vec3(x, y, z);
  };
  return robot_of({frame_at("right_shoulder_pitch_joint", at(0, -0.15, 0.3)),
                   frame_at("left_shoulder_pitch_joint", at(0, 0.15, 0.3)),
                   frame_at("left_hip_joint", at(0, 0.1, -0.1)),
                   frame_at("right_hip_joint", at(0, -0.1, -0.1)),
                   frame_at("left_ankle_joint", at(0.05, 0.1, -0.8)),
                   frame_at("right_ankle_joint", at(0.05, -0.1, -0.8)),
                   frame_at("right_palm", at(0.2, -0.2, 0))});
}

TEST(Standing, LegsAndSidesTellUpAndForwardInAnyBaseFrame) {
  for (const Eigen::AngleAxisd& turn :
       {Eigen::AngleAxisd::Identity(), Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()),
        Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()),
        Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY())}) {
    const Eigen::Matrix3d base_from_body = turn.toRotationMatrix();
    const Standing standing = standing_of(legged(base_from_body));
    EXPECT_LT((standing.up - base_from_body.col(2)).norm(), 1e-9);
    EXPECT_LT((standing.forward - base_from_body.col(0)).norm(), 1e-9);
    EXPECT_EQ(standing.evidence, "left_hip_joint");
  }
}

TEST(Standing, NamesOfLegsAreReadInEveryWayOfWritingThem) {
  for (const char* name : {"left_foot", "LHipYawPitch", "RLEG_JOINT0", "leg_left_1_joint", "l_knee",
                           "torso_lift_joint", "waist_to_torso", "r_ankle_roll", "wheel_front",
                           "Pelvis", "trunk2", "leftLeg"})
    EXPECT_TRUE(standing_of(robot_of({frame_at(name, {0, 0, -0.5}), frame_at("palm", {0, 0, 1})}))
                    .has_body())
        << name;
  for (const char* name :
       {"waist", "shoulder_pan_joint", "base_link", "lift_kit", "elbow", "fr3_joint1", "knuckle_l",
        "left_finger", "finger_hippo", "legacy_mount", "footage", "pedestrian", "wristtoe"})
    EXPECT_FALSE(standing_of(robot_of({frame_at(name, {0, 0, -0.5}), frame_at("palm", {0, 0, 1})}))
                     .has_body())
        << name;
}

TEST(Standing, TwoArmsAreABodyButTheFingersOfAHandAreNot) {
  std::vector<RobotModel::Frame> frames;
  for (const char* name : {"link_1_r", "link_2_r", "link_3_r", "link_4_r"})
    frames.push_back(frame_at(name, {0.1, -0.2, 0.4}));
  for (const char* name : {"link_1_l", "link_2_l", "link_3_l", "link_4_l"})
    frames.push_back(frame_at(name, {0.1, 0.2, 0.4}));
  frames.push_back(frame_at("palm", {0.4, -0.2, 0.4}));
  const Standing two_arms = standing_of(robot_of(frames));
  EXPECT_EQ(two_arms.evidence, "link_1_l");
  EXPECT_LT((two_arms.forward - Vec3::UnitX()).norm(), 1e-9);
  RobotModel hand = robot_of({frame_at("shoulder", {0, 0, 0}), frame_at("palm", {0.4, 0, 0})});
  for (const char* name : {"left_knuckle", "right_knuckle", "left_finger", "right_finger",
                           "left_inner_finger", "right_inner_finger", "left_pad", "right_pad"}) {
    hand.frames.push_back(frame_at(name, {0.05, name[0] == 'l' ? 0.04 : -0.04, 0}));
    hand.frames.back().parent = 0;  // beside the palm
  }
  EXPECT_FALSE(standing_of(hand).has_body());
}

TEST(Standing, WordsSayHowABaseStands) {
  const auto turned = [](double degrees, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(degrees * kRadPerDegree, axis));
  };
  const Standing arm, body{Vec3::UnitZ(), Vec3::UnitX(), "torso"};
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_EQ(standing_words(arm, Quat::Identity()), "stands upright");
  EXPECT_EQ(standing_words(arm, turned(137, z)), "stands upright");
  EXPECT_EQ(standing_words(arm, turned(20, x)),
            "stands upright, tilted by 20 degrees from straight up");
  EXPECT_EQ(standing_words(arm, turned(180, x)), "hangs");
  EXPECT_EQ(standing_words(arm, turned(172, x)), "hangs, tilted by 8 degrees from straight down");
  EXPECT_EQ(standing_words(arm, turned(90, y)), "is on its side, its axis to the person's right");
  EXPECT_EQ(standing_words(arm, turned(-105, y)),
            "is on its side, its axis to the person's left and 15 degrees down");
  EXPECT_EQ(standing_words(arm, turned(-80, x)),
            "is on its side, its axis to the front and 10 degrees up");
  EXPECT_EQ(standing_words(arm, turned(90, x)), "is on its side, its axis to the back");
  EXPECT_EQ(standing_words(body, turned(90, z)), "stands upright, facing the person's way");
  EXPECT_EQ(standing_words(body, turned(-90, z)), "stands upright, with its back to the table");
  EXPECT_EQ(standing_words(body, Quat::Identity()), "stands upright, facing the person's right");
  EXPECT_EQ(standing_words(body, turned(180, z)), "stands upright, facing the person's left");
  EXPECT_EQ(standing_words(body, turned(180, x)), "hangs head down");
}

}  // namespace
}  // namespace morphe::robot
