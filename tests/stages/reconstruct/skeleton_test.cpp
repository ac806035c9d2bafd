#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/human/arm_angles.hpp"
#include "core/human/hand.hpp"
#include "stages/import/import.hpp"
#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A skeleton whose right arm swings by known angles; the wrist joint's own axes are turned against
/// the hand's by an arbitrary rotation, as a file's are.
struct Swing {
  Demonstration demonstration;
  std::vector<human::ArmPose> poses;
  std::vector<human::ArmAngles> angles;
};
const Quat kWristFromHand(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
/// Knuckles and index finger in the hand frame, straight.
const Vec3 kIndexBase(0.004, 0.025, 0.09), kMiddleBase(0, 0, 0.093),
    kLittleBase(0.004, -0.035, 0.07);
const double kBones[] = {0.045, 0.026, 0.018};

Swing swing(std::size_t frames = 240, double rate_hz = 120) {
  Swing result;
  BodyStream& body = result.demonstration.streams.skeleton.emplace();
  body.names = {"right_shoulder",  "right_elbow",      "right_wrist",
                "right_index_mcp", "right_index_pip",  "right_index_dip",
                "right_index_tip", "right_middle_mcp", "right_little_mcp"};
  body.parents = {"",
                  "right_shoulder",
                  "right_elbow",
                  "right_wrist",
                  "right_index_mcp",
                  "right_index_pip",
                  "right_index_dip",
                  "right_wrist",
                  "right_wrist"};
  body.position = Array2D<Vec3>(frames, body.names.size(), unknown_point());
  body.orientation = Array2D<Quat>(frames, body.names.size(), unknown_rotation());
  for (std::size_t i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) / rate_hz, s = std::sin(2 * M_PI * 0.4 * t);
    const human::ArmAngles angles = {0.5 + 0.4 * s, 0.3 + 0.1 * s, 0.1 * s,        0.9 - 0.5 * s,
                                     0.2 * s,       0.1 * s,       0.05 + 0.05 * s};
    const human::ArmPose pose = human::arm_pose(Vec3(0.2, 0.05 * s, 1.3), {0.31, 0.25}, angles);
    const auto in_world = [&](const Vec3& in_hand) -> Vec3 {
      return pose.wrist + pose.world_from_hand * in_hand;
    };
    const Vec3 along(0.3, 0, std::sqrt(1 - 0.09));  // the index finger is bent at its knuckle
    const Vec3 points[] = {pose.shoulder,
                           pose.elbow,
                           pose.wrist,
                           in_world(kIndexBase),
                           in_world(kIndexBase + kBones[0] * along),
                           in_world(kIndexBase + (kBones[0] + kBones[1]) * along),
                           in_world(kIndexBase + (kBones[0] + kBones[1] + kBones[2]) * along),
                           in_world(kMiddleBase),
                           in_world(kLittleBase)};
    body.time.push_back(t);
    for (std::size_t k = 0; k < body.names.size(); ++k) {
      body.position(i, k) = points[k];
      body.orientation(i, k) = pose.world_from_hand * kWristFromHand.conjugate();
    }
    result.poses.push_back(pose);
    result.angles.push_back(angles);
  }
  return result;
}

/// The axes of the hand that the knuckles above show: z to the middle one, y from little to index.
Eigen::Matrix3d shown_axes() {
  const Vec3 z = kMiddleBase.normalized();
  const Vec3 across = kIndexBase - kLittleBase;
  const Vec3 y = (across - across.dot(z) * z).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

TEST(Skeleton, GivesBackTheArmThatMovedIt) {
  const Swing truth = swing();
  const HumanMotion motion = reconstruct(truth.demonstration, {}, {});
  ASSERT_EQ(motion.arm_angles.rows(), static_cast<Eigen::Index>(motion.time.size()));
  for (std::size_t i = 30; i < 150; i += 5) {  // 100 Hz against 120: every 5th is every 6th
    const human::ArmPose& pose = truth.poses[i * 6 / 5];
    EXPECT_LT((motion.shoulder[i] - pose.shoulder).norm(), 1e-4);
    EXPECT_LT((motion.elbow[i] - pose.elbow).norm(), 1e-4);
    EXPECT_LT((motion.wrist[i] - pose.wrist).norm(), 2e-4);
    const Quat hand(pose.world_from_hand.toRotationMatrix() * shown_axes());
    EXPECT_LT(angle_between(motion.wrist_orientation[i], hand), 1e-3);
    for (std::size_t k = 0; k < kArmAngleCount; ++k) {
      EXPECT_NEAR(motion.arm_angles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)),
                  truth.angles[i * 6 / 5][k], 2e-3)
          << kArmAngleNames[k];
    }
    EXPECT_LT(
        (motion.tip(i, 1) - truth.demonstration.streams.skeleton->position(i * 6 / 5, 6)).norm(),
        3e-4);
    EXPECT_LT(
        (motion.finger_joint(i, 1) - truth.demonstration.streams.skeleton->position(i * 6 / 5, 4))
            .norm(),
        3e-4);
    EXPECT_FALSE(is_known(motion.tip(i, 0)));
  }
  EXPECT_TRUE(motion.estimated.empty());
}

TEST(Skeleton, BonesKeepTheirLengths) {
  const HumanMotion motion = reconstruct(swing().demonstration, {}, {});
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), 0.31, 1e-9);
    EXPECT_NEAR((motion.wrist[i] - motion.elbow[i]).norm(), 0.25, 1e-9);
    EXPECT_NEAR((motion.tip(i, 1) - motion.finger_joint(i, 1)).norm(), kBones[1] + kBones[2], 1e-5);
  }
}

TEST(Skeleton, ALastBoneWithoutLengthIsEstimated) {
  Swing truth = swing();
  BodyStream& body = *truth.demonstration.streams.skeleton;
  for (std::size_t i = 0; i < body.time.size(); ++i) body.position(i, 6) = body.position(i, 5);
  const HumanMotion motion = reconstruct(truth.demonstration, {}, {});
  // 0.097 / 0.143 of the middle bone (Buchholz), straight on as the finger is.
  const Vec3 bone = motion.tip(100, 1) - motion.finger_joint(100, 1);
  EXPECT_NEAR(bone.norm(), kBones[1] * (1 + 0.097 / 0.143), 1e-5);
  EXPECT_THAT(motion.estimated, Contains("fingertips"));
  EXPECT_THAT(motion.reconstruction_notes,
              Contains(HasSubstr("the last bones of index have no length")));
}

TEST(Skeleton, SaysWhatItLacks) {
  Swing truth = swing();
  BodyStream& body = *truth.demonstration.streams.skeleton;
  body.names = {"RightArm", "right_elbow", "right_wrist", "a", "b", "c", "d", "e", "f"};
  HumanMotion motion = reconstruct(truth.demonstration, {}, {});
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("no joint named right_shoulder")));
  EXPECT_THAT(motion.reconstruction_notes,
              Contains(HasSubstr("the orientation of the hand is unknown")));
  EXPECT_THAT(motion.reconstruction_notes, Contains("the skeleton has no fingertips"));
  EXPECT_FALSE(is_known(motion.shoulder[10]));
  EXPECT_TRUE(is_known(motion.elbow[10]));
  EXPECT_FALSE(is_known(motion.wrist_orientation[10]));
  EXPECT_EQ(motion.arm_angles.rows(), 0);
  // With a thumb it is known, if not well: the index knuckle serves as one here.
  body.names = {"right_shoulder",
                "right_elbow",
                "right_wrist",
                "right_thumb_mcp",
                "b",
                "c",
                "d",
                "right_middle_mcp",
                "f"};
  motion = reconstruct(truth.demonstration, {}, {});
  EXPECT_TRUE(is_known(motion.wrist_orientation[10]));
  EXPECT_THAT(motion.estimated, Contains("wrist orientation"));
}

TEST(Skeleton, ALeftArmIsTheRightOneInTheMirror) {
  const Swing truth = swing(60);
  Demonstration left = mirror_image(truth.demonstration);
  left.hand = Side::left;
  EXPECT_EQ(left.streams.skeleton->names[6], "left_index_tip");
  EXPECT_EQ(left.streams.skeleton->parents[6], "left_index_dip");
  const HumanMotion a = reconstruct(truth.demonstration, {}, {}), b = reconstruct(left, {}, {});
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    EXPECT_LT((a.tip(i, 1) - b.tip(i, 1)).norm(), 1e-12);
    EXPECT_LT(angle_between(a.wrist_orientation[i], b.wrist_orientation[i]), 1e-7);
  }
  const Demonstration again = mirror_image(left);
  EXPECT_EQ(again.streams.skeleton->names, truth.demonstration.streams.skeleton->names);
  EXPECT_EQ(again.streams.skeleton->position.values,
            truth.demonstration.streams.skeleton->position.values);
}

TEST(Skeleton, TheShippedOnes) {
  for (const char* folder : {"cmu-iclone-bvh", "cmu-native", "pybvh"}) {
    imports::ImportRequest request;
    request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets" / folder /
                     "recordings.yaml"};
    imports::import_recordings(request, [](Demonstration&& d) {
      const HumanMotion motion = reconstruct(d, {}, {});
      const bool whole_hand = d.name != "cmu_12_01_walk";
      for (std::size_t i = 0; i < motion.time.size(); ++i) {
        ASSERT_TRUE(is_known(motion.shoulder[i]) && is_known(motion.elbow[i]) &&
                    is_known(motion.wrist[i]));
        ASSERT_TRUE(is_known(motion.wrist_orientation[i]));
        ASSERT_EQ(is_known(motion.tip(i, 1)), whole_hand);
        ASSERT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(),
                    (motion.elbow[0] - motion.shoulder[0]).norm(), 1e-9);
      }
      ASSERT_EQ(motion.hand_angles.rows() > 0, whole_hand);
      EXPECT_TRUE(motion.hand_angles.allFinite());
      const bool thumb_tells = d.name == "cmu_12_01_walk";
      EXPECT_EQ(std::ranges::count(motion.estimated, "wrist orientation"), thumb_tells ? 1 : 0);
    });
  }
}

// A hand that hangs beside the body while its subject stands: the palm faces the thigh.
TEST(Skeleton, TheHangingHandsPalmFacesTheBody) {
  for (const Side hand : {Side::right, Side::left}) {
    imports::ImportRequest request;
    request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/pybvh/recordings.yaml"};
    imports::import_recordings(request, [&](Demonstration&& d) {
      d.hand = hand;
      const HumanMotion motion = reconstruct(d, {}, {});  // a left one is mirrored
      const Vec3 out_of_palm = motion.wrist_orientation[20] * Vec3::UnitX();
      const Vec3 to_fingers = motion.wrist_orientation[20] * Vec3::UnitZ();
      const Vec3 to_thumb = motion.wrist_orientation[20] * Vec3::UnitY();
      EXPECT_LT(out_of_palm.x(), -0.6) << name_of(hand);
      EXPECT_LT(to_fingers.z(), -0.8) << name_of(hand);
      EXPECT_GT(to_thumb.y(), 0.5) << name_of(hand);
    });
  }
}

}  // namespace
}  // namespace morphe::reconstruct
