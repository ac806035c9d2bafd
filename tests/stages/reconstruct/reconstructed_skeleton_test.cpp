#include "stages/reconstruct/reconstructed_skeleton.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "stages/import/import.hpp"

namespace morphe::reconstruct {
namespace {

BodyStream skeleton_of(const HumanMotion& motion) {
  BodyStream body;
  body.reconstructed = true;
  body.time = motion.time;
  body.names = {"right_shoulder", "right_elbow",     "right_wrist",
                "right_hand",     "right_thumb_tip", "right_index_tip"};
  body.parents.assign(body.names.size(), "");
  body.position = Array2D<Vec3>(motion.time.size(), 6, unknown_point());
  body.orientation = Array2D<Quat>(motion.time.size(), 6, unknown_rotation());
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const Vec3 points[] = {motion.shoulder[i], motion.elbow[i],  motion.wrist[i],
                           motion.wrist[i],    motion.tip(i, 0), motion.tip(i, 1)};
    for (std::size_t k = 0; k < 6; ++k) body.position(i, k) = points[k];
    body.orientation(i, 3) = motion.wrist_orientation[i];
    for (std::size_t finger = 0; finger < 2; ++finger) {
      body.orientation(i, 4 + finger) = motion.tip_orientation(i, finger);
    }
  }
  return body;
}

bool same(const Vec3& a, const Vec3& b) {
  return (a - b).norm() < 1e-12 || (!is_known(a) && !is_known(b));
}
bool same(const Quat& a, const Quat& b) {
  return angle_between(a, b) < 1e-7 || (!is_known(a) && !is_known(b));
}

TEST(RebuiltSkeleton, IsTheMotionThatItWasMadeOf) {
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl/recordings.yaml"};
  std::size_t count = 0;
  imports::import_recordings(request, [&](Demonstration&& recorded) {
    const HumanMotion motion = reconstruct(recorded, {}, {});
    Demonstration written;
    written.streams.skeleton = skeleton_of(motion);
    const HumanMotion read = reconstruct(written, {}, {});
    ASSERT_EQ(read.time.size(), motion.time.size());
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      ASSERT_NEAR(read.time[i], motion.time[i], 1e-12);
      ASSERT_TRUE(same(read.shoulder[i], motion.shoulder[i])) << i;
      ASSERT_TRUE(same(read.elbow[i], motion.elbow[i])) << i;
      ASSERT_TRUE(same(read.wrist[i], motion.wrist[i])) << i;
      ASSERT_TRUE(same(read.wrist_orientation[i], motion.wrist_orientation[i])) << i;
      for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
        ASSERT_TRUE(same(read.tip(i, finger), motion.tip(i, finger))) << i;
        ASSERT_TRUE(same(read.tip_orientation(i, finger), motion.tip_orientation(i, finger))) << i;
      }
    }
    EXPECT_LT((read.arm_angles - motion.arm_angles).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_TRUE(read.estimated.empty());
    ++count;
  });
  EXPECT_EQ(count, 5U);
}

TEST(RebuiltSkeleton, WhatHasNoConfidenceWasEstimated) {
  HumanMotion motion;
  for (int i = 0; i < 3; ++i) {
    motion.time.push_back(0.01 * i);
    motion.shoulder.emplace_back(0, 0, 1.4);
    motion.elbow.emplace_back(0, 0, 1.1);
    motion.wrist.emplace_back(0, 0.25, 1.1);
    motion.wrist_orientation.push_back(Quat::Identity());
  }
  motion.tip = Array2D<Vec3>(3, kFingerCount, Vec3(0, 0.4, 1.1));
  motion.tip_orientation = Array2D<Quat>(3, kFingerCount, unknown_rotation());
  BodyStream body = skeleton_of(motion);
  body.confidence = Array2D<double>(3, 6, 1.0);
  for (std::size_t i = 0; i < 3; ++i) body.confidence(i, 1) = 0;
  const HumanMotion read = motion_from_reconstructed(body, {});
  EXPECT_THAT(read.estimated, testing::ElementsAre("elbow"));
  EXPECT_THAT(read.reconstruction_notes,
              testing::ElementsAre("estimated during reconstruction, not recorded: elbow; "
                                   "humanlikeness of the arm is relative to an estimate"));
  EXPECT_EQ(read.arm_angles.rows(), 0);
  for (std::size_t i = 0; i < 3; ++i) body.confidence(i, 1) = 1;
  EXPECT_THAT(motion_from_reconstructed(body, {}).reconstruction_notes,
              testing::Not(testing::Contains(testing::HasSubstr("estimated"))));
}

TEST(RebuiltSkeleton, BetweenItsTimesValuesAreOnStraightLines) {
  BodyStream body;
  body.reconstructed = true;
  body.time = {0, 0.02};
  body.names = {"right_wrist"};
  body.position = Array2D<Vec3>(2, 1, Vec3::Zero());
  body.position(1, 0) = Vec3(0.2, 0, 0);
  body.orientation = Array2D<Quat>(2, 1, unknown_rotation());
  const HumanMotion read = motion_from_reconstructed(body, {});
  ASSERT_EQ(read.time.size(), 3U);
  EXPECT_NEAR(read.wrist[1].x(), 0.1, 1e-12);
}

}  // namespace
}  // namespace morphe::reconstruct
