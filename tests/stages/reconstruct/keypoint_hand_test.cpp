#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/human/hand.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/import/import.hpp"
#include "stages/reconstruct/hand_from_keypoints.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// What a hand that bends slowly shows, in the hand frame: 21 points by pipeline/kinematics.
struct TrueHand {
  std::vector<HandKeypoints> points;
  JointRows angles;
};
TrueHand bending_hand(std::size_t frames, double rate_hz) {
  const RobotModel hand = human::human_hand({0.19, 0.085});
  TrueHand truth;
  truth.angles.resize(static_cast<Eigen::Index>(frames),
                      static_cast<Eigen::Index>(kHandAngleCount));
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < frames; ++i) {
    human::HandAngles angles;
    for (std::size_t k = 0; k < kHandAngleCount; ++k) {
      const auto j = static_cast<Eigen::Index>(k);
      const double phase =
          2 * M_PI * 0.3 * static_cast<double>(i) / rate_hz + static_cast<double>(k);
      const double share = 0.5 + 0.35 * std::sin(phase);
      angles.joint[k] = hand.lower[j] + share * (hand.upper[j] - hand.lower[j]);
      truth.angles(static_cast<Eigen::Index>(i), j) = angles.joint[k];
    }
    human::hand_points(hand, angles, poses);
    HandKeypoints& points = truth.points.emplace_back();
    points[0].setZero();
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const auto last = static_cast<std::size_t>(hand.tips[f].frame);
      const auto middle = static_cast<std::size_t>(hand.frames[last].parent);
      const auto base = static_cast<std::size_t>(hand.frames[middle].parent);
      points[keypoint_index(f, 0)] = poses[base].translation();
      points[keypoint_index(f, 1)] = poses[middle].translation();
      points[keypoint_index(f, 2)] = poses[last].translation();
      points[keypoint_index(f, 3)] = poses[last] * hand.tips[f].transform.translation();
    }
  }
  return truth;
}

double length(const Array2D<Vec3>& joints, std::size_t i, std::size_t a, std::size_t b) {
  return (joints(i, a) - joints(i, b)).norm();
}

TEST(KeypointHand, FindsTheAnglesOfAHandFromWhereItsJointsAre) {
  const TrueHand truth = bending_hand(200, 100);
  // Anywhere and turned from frame to frame: only the shape counts.
  std::vector<HandKeypoints> seen_points = truth.points;
  for (std::size_t i = 0; i < seen_points.size(); ++i) {
    const Eigen::AngleAxisd turn(0.02 * static_cast<double>(i), Vec3(1, 2, -1).normalized());
    for (Vec3& point : seen_points[i]) point = turn * point + Vec3(0.3, -2, 0.01);
  }
  const auto fitted = fit_hand(seen_points, std::nullopt, 100);
  ASSERT_TRUE(fitted);
  for (Eigen::Index i = 0; i < 200; ++i) {
    for (Eigen::Index k = 0; k < 20; ++k) {
      EXPECT_NEAR(fitted->angles(i, k), truth.angles(i, k), 0.01)
          << kHandAngleNames[k] << " in frame " << i;
    }
    for (std::size_t k = 0; k < kHandKeypoints; ++k) {
      EXPECT_LT((fitted->joints(static_cast<std::size_t>(i), k) -
                 truth.points[static_cast<std::size_t>(i)][k])
                    .norm(),
                1e-9);
    }
  }
  for (const Residual& residual : fitted->residuals)
    EXPECT_LT(residual.max_m, 0.0005) << residual.name;
}

TEST(KeypointHand, BonesAreConstantWhateverTheNoise) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.003);
  std::vector<HandKeypoints> points = bending_hand(100, 100).points;
  for (HandKeypoints& frame : points) {
    for (Vec3& point : frame) point += Vec3(noise(random), noise(random), noise(random));
  }
  const auto fitted = fit_hand(points, 0.2, 100);
  ASSERT_TRUE(fitted);
  double stretched = fitted->joints(0, keypoint_index(2, 0)).norm();
  for (std::size_t joint = 0; joint < 3; ++joint) {
    stretched += length(fitted->joints, 0, keypoint_index(2, joint), keypoint_index(2, joint + 1));
  }
  EXPECT_NEAR(stretched, 0.2, 1e-12);  // the hand length that was given
  for (std::size_t i = 1; i < 100; ++i) {
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      EXPECT_NEAR(fitted->joints(i, keypoint_index(f, 0)).norm(),
                  fitted->joints(0, keypoint_index(f, 0)).norm(), 1e-12);
      for (std::size_t joint = 0; joint < 3; ++joint) {
        const std::size_t a = keypoint_index(f, joint);
        EXPECT_NEAR(length(fitted->joints, i, a, a + 1), length(fitted->joints, 0, a, a + 1),
                    1e-12);
      }
    }
  }
}

TEST(KeypointHand, AFingerThatIsNotSeenStaysUnseen) {
  TrueHand truth = bending_hand(60, 100);
  for (std::size_t i = 20; i < 40; ++i) truth.points[i][keypoint_index(1, 3)] = unknown_point();
  const auto fitted = fit_hand(truth.points, std::nullopt, 100);
  ASSERT_TRUE(fitted);
  for (Eigen::Index k = 4; k < 8; ++k) {
    EXPECT_TRUE(std::isnan(fitted->angles(30, k)));
    EXPECT_NEAR(fitted->angles(45, k), truth.angles(45, k), 0.02);
  }
  EXPECT_FALSE(is_known(fitted->joints(30, keypoint_index(1, 3))));
  EXPECT_TRUE(is_known(fitted->joints(30, keypoint_index(2, 3))));
  for (HandKeypoints& frame : truth.points) frame[keypoint_index(4, 2)] = unknown_point();
  EXPECT_FALSE(fit_hand(truth.points, std::nullopt, 100));
}

/// Keypoints in their own frame, in rows of 30 a second.
Demonstration recorded(const TrueHand& truth) {
  Demonstration d;
  HandStream& hand = d.streams.hand.emplace();
  hand.kind = HandKind::keypoints;
  hand.position = Array2D<Vec3>(truth.points.size(), kHandKeypoints, unknown_point());
  for (std::size_t i = 0; i < truth.points.size(); ++i) {
    hand.time.push_back(static_cast<double>(i) / 30);
    for (std::size_t k = 0; k < kHandKeypoints; ++k) hand.position(i, k) = truth.points[i][k];
  }
  return d;
}

TEST(KeypointHand, AloneHasAnglesButNoPlace) {
  const HumanMotion motion = reconstruct(recorded(bending_hand(60, 30)), {}, {});
  ASSERT_EQ(motion.hand_angles.rows(), static_cast<Eigen::Index>(motion.time.size()));
  EXPECT_TRUE(motion.hand_angles.allFinite());
  EXPECT_FALSE(is_known(motion.tip(0, 1)));
  EXPECT_THAT(motion.reconstruction_notes,
              Contains("the wrist was not tracked: a reach cannot be found without it"));
}

TEST(KeypointHand, HangsOnATrackedWrist) {
  const TrueHand truth = bending_hand(60, 30);
  Demonstration d = recorded(truth);
  BodyStream& sensors = d.streams.sensors.emplace();
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, -1, 2).normalized()));
  const Vec3 wrist(0.2, 0.4, 0.1);
  sensors.names = {"wrist"};
  sensors.time = d.streams.hand->time;
  sensors.position = Array2D<Vec3>(60, 1, wrist);
  sensors.orientation = Array2D<Quat>(60, 1, turn);
  const HumanMotion motion = reconstruct(d, {}, {});
  for (const std::size_t i : {30u, 100u, 150u}) {  // at 100 Hz; recorded at every third of it
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const std::size_t row = i * 30 / 100;
      EXPECT_LT(
          (motion.tip(i, f) - (wrist + turn * truth.points[row][keypoint_index(f, 3)])).norm(),
          0.001);
      EXPECT_LT(
          (motion.finger_joint(i, f) - (wrist + turn * truth.points[row][keypoint_index(f, 1)]))
              .norm(),
          0.001);
    }
  }
}

TEST(KeypointHand, TheShippedHandKeepsItsBones) {
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) /
                   "datasets/dex-retargeting/recordings.yaml"};
  imports::import_recordings(request, [](Demonstration&& d) {
    const HumanMotion motion = reconstruct(d, {}, {});
    EXPECT_EQ(motion.time.size(), 2067u);
    EXPECT_TRUE(motion.hand_angles.allFinite());
    double fastest = 0;
    for (Eigen::Index i = 1; i < motion.hand_angles.rows(); ++i) {
      fastest = std::max(
          fastest,
          (motion.hand_angles.row(i) - motion.hand_angles.row(i - 1)).cwiseAbs().maxCoeff());
    }
    EXPECT_LE(fastest, 0.3 + 1e-12);  // 30 rad/s
    ASSERT_EQ(motion.residuals.front().name, "keypoints, bones constant");
    // The recorded palm alone goes from 81 to 111 mm.
    EXPECT_GT(motion.residuals.front().rms_m, 0.002);
    EXPECT_LT(motion.residuals.front().rms_m, 0.008);
    EXPECT_THAT(motion.reconstruction_notes,
                Contains(HasSubstr("a reach cannot be found without it")));
  });
}

}  // namespace
}  // namespace morphe::reconstruct
