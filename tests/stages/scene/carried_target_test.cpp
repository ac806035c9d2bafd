#include "stages/scene/carried_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace morphe::scene {
namespace {

Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// A rigid hand that flies and turns; thumb and index hold (0.2, 0.3, 0.1) between them at 0.5 s.
struct Carrying {
  HumanMotion motion;
  Movement movement;
  SceneObject cup;

  static Pose world_from_hand(double time_s) {
    Pose pose = Pose::Identity();
    pose.linear() = (about(Vec3(1, 2, 3), 1.5 * time_s) * about(Vec3::UnitX(), 0.3)).matrix();
    pose.translation() = Vec3(0.2 + time_s, 0.3 - 0.2 * std::sin(3 * time_s), 0.1 * time_s);
    return pose;
  }
  explicit Carrying(bool oriented) {
    constexpr std::size_t kFrames = 101;
    motion.tip = Array2D<Vec3>(kFrames, kFingerCount, unknown_point());
    for (std::size_t k = 0; k < kFrames; ++k) {
      const double time_s = 0.01 * static_cast<double>(k);
      const Pose pose = world_from_hand(time_s);
      motion.time.push_back(time_s);
      motion.tip(k, 0) = pose * Vec3(0.02, 0.04, 0.1);
      motion.tip(k, 1) = pose * Vec3(0.03, -0.04, 0.12);
      motion.wrist_orientation.push_back(oriented ? Quat(pose.linear()) : unknown_rotation());
    }
    movement.begin_s = 0;
    movement.end_s = 0.9;
    cup.time = {0};
    cup.position = {world_from_hand(0.5) * Vec3(0.03, 0.01, 0.1)};
    cup.orientation = {Quat::Identity()};
    cup.attach_s = 0.5;
    cup.release_s = 0.8;
  }
  Pose expected(double time_s) const {
    Pose world_from_cup = Pose::Identity();
    world_from_cup.translation() = world_from_hand(0.5) * Vec3(0.03, 0.01, 0.1);
    return world_from_hand(time_s) * world_from_hand(0.5).inverse() * world_from_cup;
  }
};

TEST(CarriedTarget, MovesRigidlyWithTheHand) {
  Carrying c(true);
  c.motion.tip(60, 1) = unknown_point();  // bridged
  move_with_tips(c.motion, c.movement, c.cup);
  EXPECT_EQ(c.cup.time.size(), 30u);
  EXPECT_NEAR(c.cup.time.front(), 0.5, 1e-12);
  EXPECT_NEAR(c.cup.time.back(), 0.8, 1e-12);
  for (const double time_s : {0.0, 0.5, 0.55, 0.7, 0.8, 1.0}) {
    const Pose got = recorded_pose(c.cup, time_s);
    const Pose want = c.expected(std::clamp(time_s, 0.5, 0.8));
    EXPECT_LT((got.matrix() - want.matrix()).norm(), 1e-9) << time_s;
  }
}

TEST(CarriedTarget, TheTipsStayWhereTheyWereOnIt) {
  Carrying c(false);
  // They come 4 mm nearer to each other, and the hand's orientation is not seen.
  for (std::size_t k = 50; k <= 100; ++k) {
    const double closer = 0.002 * static_cast<double>(k - 50) / 50;
    const Vec3 line = (c.motion.tip(k, 1) - c.motion.tip(k, 0)).normalized();
    c.motion.tip(k, 0) += closer * line;
    c.motion.tip(k, 1) -= closer * line;
  }
  move_with_tips(c.motion, c.movement, c.cup);
  const auto on_cup = [&](std::size_t frame, std::size_t tip) {
    return Vec3(recorded_pose(c.cup, c.motion.time[frame]).inverse() * c.motion.tip(frame, tip));
  };
  for (const std::size_t frame : {50u, 60u, 75u, 80u}) {
    for (const std::size_t tip : {0u, 1u}) {
      EXPECT_LT((on_cup(frame, tip) - on_cup(50, tip)).norm(), 0.0021);
    }
  }
}

TEST(CarriedTarget, KeepsItsOwnMotionAndStaysWhereNothingWasSeen) {
  Carrying c(true);
  SceneObject recorded = c.cup;
  recorded.time = {0, 1};
  recorded.position = {Vec3::Zero(), Vec3::UnitX()};
  recorded.orientation = {Quat::Identity(), Quat::Identity()};
  move_with_tips(c.motion, c.movement, recorded);
  EXPECT_EQ(recorded.time.size(), 2u);
  c.motion.tip = Array2D<Vec3>(c.motion.time.size(), kFingerCount, unknown_point());
  const Vec3 before = c.cup.position.front();
  move_with_tips(c.motion, c.movement, c.cup);
  ASSERT_EQ(c.cup.time.size(), 1u);
  EXPECT_EQ(c.cup.position.front(), before);
}

TEST(CarriedTarget, StopsWithTheMovement) {
  Carrying c(true);
  c.movement.end_s = 0.6;
  move_with_tips(c.motion, c.movement, c.cup);
  EXPECT_NEAR(c.cup.time.back(), 0.6, 1e-12);
}

}  // namespace
}  // namespace morphe::scene
