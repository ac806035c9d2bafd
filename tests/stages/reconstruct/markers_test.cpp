#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "tests/stages/reconstruct/synthetic_arm.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

std::vector<std::string> names_of(const std::vector<Residual>& residuals) {
  std::vector<std::string> names;
  for (const Residual& residual : residuals) names.push_back(residual.name);
  return names;
}

TEST(MotionFromMarkers, FindsTheExactArmOfSyntheticClusters) {
  ReconstructOptions options;
  options.thumb_marker_to_axis_m = options.index_marker_to_axis_m = 0;
  const SyntheticArm arm = synthetic_arm();
  const HumanMotion motion = reconstruct(arm.demonstration, options, {});
  EXPECT_TRUE(motion.reconstruction_notes.empty());
  EXPECT_TRUE(motion.estimated.empty());
  ASSERT_EQ(motion.time.size(), arm.shoulder.size());
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    // The arm stands still in the first and last second, where the filter changes nothing.
    const double tolerance = i < 50 || i + 50 > motion.time.size() ? 1e-5 : 2e-3;
    EXPECT_LT((motion.shoulder[i] - arm.shoulder[i]).norm(), tolerance);
    EXPECT_LT((motion.elbow[i] - arm.elbow[i]).norm(), tolerance);
    EXPECT_LT((motion.wrist[i] - arm.wrist[i]).norm(), tolerance);
    EXPECT_LT(angle_between(motion.wrist_orientation[i], arm.world_from_hand[i]), 0.02);
    EXPECT_LT((motion.tip(i, 0) - arm.thumb[i]).norm(), tolerance);
    EXPECT_LT((motion.tip(i, 1) - arm.index[i]).norm(), tolerance);
    EXPECT_FALSE(is_known(motion.tip(i, 2)));
    EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), arm.upper_arm, 1e-9);
  }
  EXPECT_THAT(names_of(motion.residuals),
              IsSupersetOf({"RUAR rigid fit", "elbow, RUAR against RLAR",
                            "wrist, RLAR against RHAN", "upper arm length", "forearm length"}));
  for (const Residual& residual : motion.residuals) EXPECT_LT(residual.max_m, 3e-3);
}

TEST(MotionFromMarkers, HandFrameFollowsTheConventionOfARightHand) {
  const SyntheticArm arm = synthetic_arm();
  const HumanMotion motion = reconstruct(arm.demonstration, {}, {});
  // In the static pose of synthetic_arm the hand points forward, thumb up, palm to the left.
  const Eigen::Matrix3d axes = motion.wrist_orientation[0].toRotationMatrix();
  EXPECT_LT((axes.col(0) - Vec3(-1, 0, 0)).norm(), 1e-4);
  EXPECT_LT((axes.col(1) - Vec3(0, 0, 1)).norm(), 1e-4);
  EXPECT_LT((axes.col(2) - Vec3(0, 1, 0)).norm(), 1e-4);
}

TEST(MotionFromMarkers, TipsMoveFromTheNailTowardsEachOther) {
  const SyntheticArm arm = synthetic_arm();
  ReconstructOptions options;
  options.thumb_marker_to_axis_m = 0.010;
  options.index_marker_to_axis_m = 0.015;
  const HumanMotion motion = reconstruct(arm.demonstration, options, {});
  const Vec3 across = (arm.index[0] - arm.thumb[0]).normalized();
  EXPECT_LT((motion.tip(0, 0) - arm.thumb[0] - 0.010 * across).norm(), 1e-5);
  EXPECT_LT((motion.tip(0, 1) - arm.index[0] + 0.015 * across).norm(), 1e-5);
}

TEST(MotionFromMarkers, OneMarkerMissingChangesNothingTwoAreReported) {
  SyntheticArm arm = synthetic_arm();
  MarkerStream& markers = *arm.demonstration.streams.markers;
  const HumanMotion whole = reconstruct(arm.demonstration, {}, {});
  const auto hide = [&](const std::string& name) {
    const auto k = static_cast<std::size_t>(
        std::find(markers.names.begin(), markers.names.end(), name) - markers.names.begin());
    for (std::size_t i = 0; i < markers.time.size(); ++i) markers.position(i, k) = unknown_point();
  };
  hide("RHAN2");
  const HumanMotion one = reconstruct(arm.demonstration, {}, {});
  EXPECT_TRUE(one.reconstruction_notes.empty());
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    EXPECT_LT((one.wrist[i] - whole.wrist[i]).norm(), 1e-5);  // rotations of 1e-5 by the filter
  }
  hide("RHAN3");
  const HumanMotion two = reconstruct(arm.demonstration, {}, {});
  EXPECT_THAT(two.reconstruction_notes, Contains(HasSubstr("cluster RHAN")));
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    EXPECT_FALSE(is_known(two.wrist_orientation[i]));
    EXPECT_LT((two.wrist[i] - whole.wrist[i]).norm(), 2e-3);  // of the forearm alone
    EXPECT_TRUE(is_known(two.tip(i, 0)));
  }
  arm.demonstration.calibration.markers.reset();
  const HumanMotion unknown = reconstruct(arm.demonstration, {}, {});
  EXPECT_THAT(unknown.estimated, testing::ElementsAre("shoulder", "elbow"));
  EXPECT_THAT(unknown.reconstruction_notes, Contains(HasSubstr("wrist: RSPR, RSPU were not seen")));
  EXPECT_FALSE(is_known(unknown.wrist[0]));
  EXPECT_TRUE(is_known(unknown.tip(0, 1)));
}

TEST(MotionFromMarkers, AHiddenTipDoesNotHideTheOther) {
  SyntheticArm arm = synthetic_arm();
  MarkerStream& markers = *arm.demonstration.streams.markers;
  const HumanMotion whole = reconstruct(arm.demonstration, {}, {});
  const std::size_t index = markers.names.size() - 1;
  ASSERT_EQ(markers.names[index], "RFTP");
  for (std::size_t i = 130; i < 170; ++i) markers.position(i, index) = unknown_point();
  const HumanMotion part = reconstruct(arm.demonstration, {}, {});
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    EXPECT_LT((part.tip(i, 0) - whole.tip(i, 0)).norm(), 1e-3);  // the hand is one rigid body
    EXPECT_EQ(is_known(part.tip(i, 1)), i < 130 || i >= 170);
  }
}

TEST(MotionFromMarkers, AClusterThatDoesNotFitTheStaticTrialIsReported) {
  SyntheticArm arm = synthetic_arm();
  EXPECT_TRUE(reconstruct(arm.demonstration, {}, {}).reconstruction_notes.empty());
  MarkerStream& still = *arm.demonstration.calibration.markers;
  ASSERT_EQ(still.names[5], "RLAR2");
  still.position(0, 5) += Vec3(0, 0.02, 0);
  EXPECT_THAT(reconstruct(arm.demonstration, {}, {}).reconstruction_notes,
              Contains(HasSubstr("cluster RLAR does not fit the static trial")));
}

TEST(MotionFromMarkers, LeftHandIsTheMirroredRightOne) {
  const SyntheticArm arm = synthetic_arm();
  const HumanMotion right = reconstruct(arm.demonstration, {}, {});
  Demonstration left = mirror_image(arm.demonstration);
  left.hand = Side::left;
  EXPECT_THAT(left.streams.markers->names, Contains("LHAN1"));
  const HumanMotion motion = reconstruct(left, {}, {});
  ASSERT_EQ(motion.time.size(), right.time.size());
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    EXPECT_EQ(motion.wrist[i], right.wrist[i]);
    EXPECT_EQ(motion.wrist_orientation[i].coeffs(), right.wrist_orientation[i].coeffs());
  }
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("left hand")));
}

}  // namespace
}  // namespace morphe::reconstruct
