#include "stages/reconstruct/other_arm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "stages/reconstruct/mirror.hpp"

namespace morphe::reconstruct {
namespace {

constexpr std::size_t kFrames = 201;
constexpr double kRate_hz = 100;

const Vec3 kLeftElbow(-0.22, 0.02, 1.1);

/// About the elbow, slow enough that the low-pass leaves it where it is.
Vec3 left_wrist(double t) {
  const double turn = 0.2 * std::sin(t);
  return kLeftElbow + 0.24 * Vec3(std::sin(turn), std::cos(turn), 0);
}

/// Both arms of one skeleton: the right one stands, the left one swings about a still elbow.
Demonstration both_arms() {
  Demonstration demonstration;
  BodyStream& body = demonstration.streams.skeleton.emplace();
  body.names = {"right_shoulder", "right_elbow", "right_wrist",
                "left_shoulder",  "left_elbow",  "left_wrist"};
  body.parents = {"", "right_shoulder", "right_elbow", "", "left_shoulder", "left_elbow"};
  body.position = Array2D<Vec3>(kFrames, 6, unknown_point());
  body.orientation = Array2D<Quat>(kFrames, 6, unknown_rotation());
  for (std::size_t i = 0; i < kFrames; ++i) {
    const double t = static_cast<double>(i) / kRate_hz;
    body.time.push_back(t);
    const Vec3 points[] = {{0.2, 0, 1.4},  {0.22, 0.02, 1.1}, {0.2, 0.25, 1.1},
                           {-0.2, 0, 1.4}, kLeftElbow,        left_wrist(t)};
    for (std::size_t k = 0; k < 6; ++k) body.position(i, k) = points[k];
  }
  return demonstration;
}

TEST(OtherArm, StandsBesideTheArmThatIsPlanned) {
  const Demonstration recorded = both_arms();
  Demonstration as_left = mirror_image(recorded);
  as_left.hand = Side::left;
  // A left hand's motion is a right one in the mirror: all of it is as if the right hand's had been
  // recorded.
  for (const Demonstration& demonstration : {recorded, as_left}) {
    const HumanMotion own = reconstruct(demonstration, {}, {});
    const HumanMotion other = reconstruct_other_arm(demonstration, {}, {}, Side::right);
    const HumanMotion in_mirror = reconstruct_other_arm(demonstration, {}, {}, Side::left);
    ASSERT_EQ(other.time, own.time);
    for (std::size_t i = 20; i + 20 < kFrames; ++i) {
      EXPECT_LT((own.wrist[i] - Vec3(0.2, 0.25, 1.1)).norm(), 1e-9);
      EXPECT_LT((other.wrist[i] - left_wrist(other.time[i])).norm(), 1e-4);
      EXPECT_LT((other.shoulder[i] - Vec3(-0.2, 0, 1.4)).norm(), 1e-4);
      EXPECT_EQ(in_mirror.wrist[i],
                Vec3(-other.wrist[i].x(), other.wrist[i].y(), other.wrist[i].z()));
    }
  }
}

TEST(OtherArm, StreamsOfOneHandSayNothingOfTheOther) {
  // A tracked arm with a glove, and a skeleton that has the right arm alone.
  Demonstration tracked;
  BodyStream& sensors = tracked.streams.sensors.emplace();
  sensors.names = {"shoulder", "elbow", "wrist"};
  sensors.position = Array2D<Vec3>(kFrames, 3, Vec3(0.2, 0.3, 1));
  sensors.orientation = Array2D<Quat>(kFrames, 3, Quat::Identity());
  for (std::size_t i = 0; i < kFrames; ++i) sensors.time.push_back(0.01 * static_cast<double>(i));
  tracked.streams.hand = HandStream{
      HandKind::fingertips, {}, sensors.time, {}, Array2D<Vec3>(kFrames, 5, Vec3(0.2, 0.4, 1))};
  ASSERT_TRUE(is_known(reconstruct(tracked, {}, {}).wrist[100]));
  EXPECT_TRUE(reconstruct_other_arm(tracked, {}, {}, Side::right).time.empty());

  Demonstration one_armed = both_arms();
  BodyStream& body = *one_armed.streams.skeleton;
  for (std::size_t k = 3; k < 6; ++k) body.names[k] = "unknown_" + std::to_string(k);
  const HumanMotion other = reconstruct_other_arm(one_armed, {}, {}, Side::right);
  for (const auto* joint : {&other.shoulder, &other.elbow, &other.wrist}) {
    for (const Vec3& point : *joint) EXPECT_FALSE(is_known(point));
  }
}

}  // namespace
}  // namespace morphe::reconstruct
