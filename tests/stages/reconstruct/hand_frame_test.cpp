#include "stages/reconstruct/hand_frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/import/import.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "tests/stages/reconstruct/gloved_arm.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::Not;

Demonstration shipped_keypoints() {
  Demonstration shipped;
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) /
                   "datasets/dex-retargeting/recordings.yaml"};
  imports::import_recordings(request, [&](Demonstration&& d) { shipped = std::move(d); });
  return shipped;
}

/// One frame, by hand: the wrist at (1, 2, 3), turned by 90 degrees about Z.
TEST(HandFrame, FingersAreRelativeToTheWrist) {
  HumanMotion motion;
  motion.time = {0, 0.01};
  motion.shoulder = motion.elbow = {Vec3::Zero(), Vec3::Zero()};
  motion.wrist = {Vec3(1, 2, 3), unknown_point()};
  motion.wrist_orientation.assign(2, Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ())));
  motion.tip = motion.finger_joint = {2, kFingerCount, Vec3(1, 2.5, 3.25)};
  motion.tip_orientation = {2, kFingerCount, motion.wrist_orientation[0]};
  motion.estimated = {"shoulder", "elbow", "hand length"};
  const HumanMotion hand = transform_to_hand_frame(motion);
  for (const Vec3& point : {hand.tip(0, 0), hand.finger_joint(0, 4)}) {
    EXPECT_LT((point - Vec3(0.5, 0, 0.25)).norm(), 1e-15);
  }
  EXPECT_LT(angle_between(hand.tip_orientation(0, 2), Quat::Identity()), 1e-7);
  EXPECT_EQ(hand.wrist[0], Vec3::Zero());
  EXPECT_TRUE(hand.wrist_orientation[0].isApprox(Quat::Identity()));
  EXPECT_FALSE(is_known(hand.shoulder[0]));
  EXPECT_FALSE(is_known(hand.elbow[0]));
  EXPECT_FALSE(is_known(hand.tip(1, 0)));  // no wrist, no hand
  EXPECT_FALSE(is_known(hand.wrist[1]));
  EXPECT_THAT(hand.estimated, testing::ElementsAre("hand length"));
}

/// What no wrist was recorded with has fingers, in the hand's own frame: the file's, whose wrist is
/// the origin, up to bones that are held constant (8 mm RMS) and the low-pass.
TEST(HandFrame, KeypointsHaveFingersOnAStillWrist) {
  const Demonstration recorded = shipped_keypoints();
  EXPECT_FALSE(is_known(reconstruct(recorded, {}, {}).tip(0, 1)));
  const HumanMotion motion = transform_to_hand_frame(reconstruct_hand(recorded, {}, {}));
  ASSERT_EQ(motion.time.size(), 2067u);
  for (const std::size_t row : {0u, 300u, 600u}) {
    const std::size_t i = row * 100 / 30;
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      const double file = recorded.streams.hand->position(row, 4 * finger + 4).norm();
      EXPECT_NEAR(motion.tip(i, finger).norm(), file, 0.03) << row << " " << finger;
    }
    // Knuckles ahead of the wrist, the thumb at the thumb's side.
    EXPECT_GT(motion.finger_joint(i, 2).z(), 0.05);
    EXPECT_GT(motion.finger_joint(i, 0).y(), 0.0);
  }
  EXPECT_THAT(motion.estimated, Not(Contains("shoulder")));
  EXPECT_THAT(motion.estimated, Contains("wrist"));
}

TEST(HandFrame, AGloveAloneHasItsFingersToo) {
  const GlovedArm truth;
  Demonstration d = truth.record();
  const HumanMotion whole = transform_to_hand_frame(reconstruct_hand(d, {}, {}));
  d.streams.sensors.reset();
  const HumanMotion alone = transform_to_hand_frame(reconstruct_hand(d, {}, {}));
  for (const HumanMotion* motion : {&whole, &alone}) {
    const std::size_t i = motion->time.size() / 2;
    const human::HandPoints points = truth.points(motion->time[i]);
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      EXPECT_LT((motion->tip(i, finger) - points.tip[finger]).norm(), 0.001);
      EXPECT_LT((motion->finger_joint(i, finger) - points.middle_joint[finger]).norm(), 0.001);
    }
  }
}

TEST(HandFrame, ATrackedWristIsLeftAlone) {
  Demonstration d = shipped_keypoints();
  BodyStream& sensors = d.streams.sensors.emplace();
  sensors.names = {"wrist"};
  sensors.time = d.streams.hand->time;
  sensors.position = {sensors.time.size(), 1, Vec3(0.2, 0.4, 0.1)};
  sensors.orientation = {sensors.time.size(), 1, Quat::Identity()};
  const HumanMotion motion = reconstruct_hand(d, {}, {});
  EXPECT_LT((motion.wrist[100] - Vec3(0.2, 0.4, 0.1)).norm(), 1e-9);
  EXPECT_THAT(motion.estimated, Not(Contains("wrist")));
}

}  // namespace
}  // namespace morphe::reconstruct
