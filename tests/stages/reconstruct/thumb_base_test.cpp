#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/reconstruct/hand_frame.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::HasSubstr;

Pose turned(double angle, const Vec3& axis) { return Pose(Eigen::AngleAxisd(angle, axis)); }

/// Joints of the simulated Adroit hand in its palm's axes, from recorded angles: a chain of turns,
/// each bone along z (the public model's; stages/import has its tips).
HandKeypoints adroit_joints(const Eigen::RowVectorXd& q) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  HandKeypoints joints;
  joints[0].setZero();
  const auto finger = [&](std::size_t which, Pose at, const std::array<Pose, 3>& turns,
                          const std::array<double, 3>& bones) {
    joints[keypoint_index(which, 0)] = at.translation();
    for (std::size_t k = 0; k < 3; ++k) {
      at = at * turns[k] * Eigen::Translation3d(bones[k] * z);
      joints[keypoint_index(which, k + 1)] = at.translation();
    }
  };
  const auto from = [&](const Vec3& base, std::size_t which, Eigen::Index first,
                        const Pose& palm = Pose::Identity()) {
    finger(which, palm * Eigen::Translation3d(base),
           {turned(q[first], y) * turned(q[first + 1], x), turned(q[first + 2], x),
            turned(q[first + 3], x)},
           {0.045, 0.025, 0.026});
  };
  finger(kThumb, Pose(Eigen::Translation3d(0.034, -0.009, 0.029)),
         {turned(M_PI / 4, y) * turned(q[22], -z) * turned(q[23], x),
          turned(q[24], x) * turned(q[25], y), turned(q[26], y)},
         {0.038, 0.032, 0.0275});
  from({0.033, 0, 0.095}, kIndex, 5);
  from({0.011, 0, 0.099}, kMiddle, 9);
  from({-0.011, 0, 0.095}, kRing, 13);
  from({-0.017, 0, 0.044}, kLittle, 18,
       Pose(Eigen::Translation3d(-0.017, 0, 0.044)) *
           turned(q[17], Vec3(0.571, 0, 0.821).normalized()));
  return joints;
}

/// The same hand with and without the thumb's base.
struct TwoFits {
  FittedHand whole, baseless;
  explicit TwoFits(std::vector<HandKeypoints> frames) {
    whole = *fit_hand(frames, std::nullopt, 100);
    for (HandKeypoints& points : frames) points[keypoint_index(kThumb, 0)] = unknown_point();
    baseless = *fit_hand(frames, std::nullopt, 100);
  }
  double roll_of_thumb() const {  // median angle between the two orientations of its tip [rad]
    std::vector<double> angles;
    for (std::size_t i = 0; i < whole.tip_orientation.rows; ++i) {
      angles.push_back(
          angle_between(whole.tip_orientation(i, kThumb), baseless.tip_orientation(i, kThumb)));
    }
    return math::median(angles);
  }
  double thumb_angle(Eigen::Index k) const {  // median difference of one of its angles [rad]
    std::vector<double> differences;
    for (Eigen::Index i = 0; i < whole.angles.rows(); ++i) {
      differences.push_back(std::abs(whole.angles(i, k) - baseless.angles(i, k)));
    }
    return math::median(differences);
  }
  void expect_the_fingers_alike() const {
    EXPECT_LT((whole.angles.rightCols(16) - baseless.angles.rightCols(16)).cwiseAbs().maxCoeff(),
              1e-9);
    for (std::size_t i = 0; i < whole.tip_orientation.rows; ++i) {
      for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
        const Quat &a = whole.tip_orientation(i, finger), &b = baseless.tip_orientation(i, finger);
        // Where the last bone points is recorded, the thumb's, too.
        EXPECT_LT((a * Vec3::UnitZ() - b * Vec3::UnitZ()).norm(), finger == kThumb ? 0.02 : 1e-9);
      }
    }
  }
};

TEST(ThumbBase, OfTheShippedAdroitHandsIsNotNeeded) {
  for (const Demonstration& d : imports::shipped_recordings("adroit-dapg")) {
    const JointRows& angles = d.streams.arm_angles->angles;
    std::vector<HandKeypoints> frames;
    for (Eigen::Index i = 0; i < angles.rows(); ++i) frames.push_back(adroit_joints(angles.row(i)));
    const TwoFits fits(frames);
    EXPECT_FALSE(fits.whole.thumb_base_estimated);
    EXPECT_TRUE(fits.baseless.thumb_base_estimated);
    fits.expect_the_fingers_alike();
    EXPECT_LT(fits.roll_of_thumb(), 5 * kDegree) << d.name;  // 2.1 to 4.6
    // Rotation, abduction, MCP and IP of the thumb, measured: at most 1.2, 8.0, 7.7 and 2.8
    // degrees.
    for (Eigen::Index k = 0; k < 4; ++k) EXPECT_LT(fits.thumb_angle(k), 9 * kDegree) << d.name;
    EXPECT_LT((fits.whole.bones.knuckle[kThumb] - fits.baseless.bones.knuckle[kThumb]).norm(),
              0.012)
        << d.name;  // 9 to 11.5 mm
  }
}

TEST(ThumbBase, OfARealHandIsNotNeeded) {
  const Demonstration d = imports::shipped_recordings("dex-retargeting").front();
  const HandStream& hand = *d.streams.hand;
  std::vector<HandKeypoints> frames(hand.time.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (std::size_t k = 0; k < kHandKeypoints; ++k) frames[i][k] = hand.position(i, k);
  }
  const TwoFits fits(frames);
  fits.expect_the_fingers_alike();
  EXPECT_LT(fits.roll_of_thumb(), 12 * kDegree);                                      // 10.5
  for (Eigen::Index k = 0; k < 4; ++k) EXPECT_LT(fits.thumb_angle(k), 13 * kDegree);  // up to 12.0
  EXPECT_LT((fits.whole.bones.knuckle[kThumb] - fits.baseless.bones.knuckle[kThumb]).norm(),
            0.018);  // 17 mm
}

TEST(ThumbBase, AriasHandsHaveTipsThatAreTurned) {
  ReconstructOptions options;
  options.max_gap_s = 0.5;  // the shipped hands come five times a second, with holes
  std::size_t hands = 0;
  for (const Demonstration& d : imports::shipped_recordings("aria")) {
    if (!d.streams.hand) continue;  // wrists alone
    ++hands;
    const HumanMotion motion = reconstruct_hand(d, options, {});
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      std::size_t turned_tips = 0, tips = 0;
      for (std::size_t i = 0; i < motion.time.size(); ++i) {
        tips += is_known(motion.tip(i, finger)) ? 1 : 0;
        turned_tips += is_known(motion.tip_orientation(i, finger)) ? 1 : 0;
      }
      EXPECT_GE(turned_tips, 40u) << d.name;  // two rows 0.4 s apart, if not 12 s
      EXPECT_EQ(turned_tips, tips) << d.name;
    }
    EXPECT_THAT(reconstruct_hand(d, {}, {}).reconstruction_notes,
                Contains(HasSubstr("never seen twice within reconstruct.max_gap_s (0.1 s)")));
    EXPECT_THAT(motion.estimated, Contains("thumb base")) << d.name;
    EXPECT_THAT(motion.reconstruction_notes,
                Contains(HasSubstr("the thumb's base (CMC) was not recorded")));
  }
  EXPECT_EQ(hands, 3u);
}

TEST(ThumbBase, IsTheOnlyPointThatMayBeMissing) {
  const Demonstration d = imports::shipped_recordings("dex-retargeting").front();
  for (const std::size_t missing : {keypoint_index(kThumb, 1), keypoint_index(kIndex, 0)}) {
    std::vector<HandKeypoints> frames(100);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      for (std::size_t k = 0; k < kHandKeypoints; ++k) {
        frames[i][k] = k == missing || k == keypoint_index(kThumb, 0)
                           ? unknown_point()
                           : d.streams.hand->position(i, k);
      }
    }
    EXPECT_FALSE(fit_hand(frames, std::nullopt, 100)) << missing;
  }
}

}  // namespace
}  // namespace morphe::reconstruct
