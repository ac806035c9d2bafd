// Joints found from how the arm moves, on an arm whose joints are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kMarkerNoise = 0.0003;  // [m] in each direction, of every marker

struct MovingArm {
  Demonstration demonstration;
  std::vector<Vec3> shoulder, elbow, wrist;
  MarkerStream& markers() { return *demonstration.streams.markers; }
  std::size_t column(const std::string& name) {
    const auto& names = markers().names;
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end());
    return static_cast<std::size_t>(found - names.begin());
  }
};

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); }

/// Ten seconds of slow turns in every joint (below 1 Hz, where the filter changes nothing) about
/// centres that no marker shows. Clusters of `size` markers, and `landmarks` on the bones.
MovingArm moving_arm(std::size_t size, bool landmarks) {
  const Vec3 shoulder(0.2, -0.3, 0.35), to_elbow(0, 0, -0.29), to_wrist(0, 0.02, -0.25);
  const Vec3 corners[4] = {
      {0.05, 0, 0.01}, {0.045, 0.05, -0.02}, {0.05, 0.01, 0.06}, {0.06, 0.04, 0.03}};
  struct Marker {
    std::string name;
    int segment;  // 0 upper arm, 1 forearm, 2 hand
    Vec3 place;   // from the segment's upper joint
  };
  std::vector<Marker> all;
  const Vec3 middles[3] = {to_elbow / 2, to_wrist / 2, Vec3(0, 0, -0.06)};
  const char* clusters[3] = {"RUAR", "RLAR", "RHAN"};
  for (int s = 0; s < 3; ++s) {
    for (std::size_t k = 0; k < size; ++k) {
      all.push_back({clusters[s] + std::to_string(k + 1), s, middles[s] + corners[k]});
    }
  }
  if (landmarks) {
    all.push_back({"RGTH", 0, Vec3::Zero()});
    all.push_back({"RLEP", 0, to_elbow + Vec3(0.04, 0, 0)});
    all.push_back({"RMEP", 0, to_elbow - Vec3(0.04, 0, 0)});
    all.push_back({"RSPR", 1, to_wrist + Vec3(0, 0.025, 0)});
    all.push_back({"RSPU", 1, to_wrist - Vec3(0, 0.025, 0)});
    all.push_back({"RFB", 2, Vec3(0, 0, -0.09)});
  }
  MovingArm arm;
  MarkerStream markers;
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, kMarkerNoise);
  const std::size_t frames = 1000;
  markers.position = Array2D<Vec3>(frames, all.size(), unknown_point());
  for (const Marker& marker : all) markers.names.push_back(marker.name);
  for (std::size_t i = 0; i < frames; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    markers.time.push_back(t);
    const Quat upper = turn(0.6 + 0.5 * std::sin(1.9 * t), Vec3::UnitX()) *
                       turn(0.4 * std::sin(1.3 * t + 1), Vec3::UnitY()) *
                       turn(0.4 * std::sin(2.3 * t), Vec3::UnitZ());
    const Quat fore = upper * turn(1.2 + 0.6 * std::sin(2.1 * t + 2), Vec3::UnitX()) *
                      turn(0.6 * std::sin(1.7 * t), Vec3::UnitZ());
    const Quat hand = fore * turn(0.5 * std::sin(2.9 * t), Vec3::UnitY()) *
                      turn(0.3 * std::sin(2.4 * t + 1), Vec3::UnitX());
    const Vec3 elbow = shoulder + upper * to_elbow, wrist = elbow + fore * to_wrist;
    const Pose poses[3] = {make_pose(shoulder, upper), make_pose(elbow, fore),
                           make_pose(wrist, hand)};
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Vec3 noise(normal(random), normal(random), normal(random));
      markers.position(i, k) = poses[all[k].segment] * all[k].place + noise;
    }
    arm.shoulder.push_back(shoulder);
    arm.elbow.push_back(elbow);
    arm.wrist.push_back(wrist);
  }
  arm.demonstration.streams.markers = std::move(markers);
  return arm;
}

/// Hides a marker for `length` frames, every `period` frames.
void hide(MovingArm& arm, const std::string& name, std::size_t first, std::size_t length,
          std::size_t period) {
  const std::size_t k = arm.column(name);
  for (std::size_t begin = first; begin < arm.markers().time.size(); begin += period) {
    for (std::size_t i = begin; i < std::min(begin + length, arm.markers().time.size()); ++i) {
      arm.markers().position(i, k) = unknown_point();
    }
  }
}

double rms(const std::vector<Vec3>& found, const std::vector<Vec3>& truth) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!is_known(found[i])) continue;
    sum += (found[i] - truth[i]).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

void expect_all_seen(const HumanMotion& motion) {
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    ASSERT_TRUE(is_known(motion.shoulder[i]) && is_known(motion.elbow[i]) &&
                is_known(motion.wrist[i]))
        << i;
  }
}

void expect_joints(const HumanMotion& motion, const MovingArm& arm, double within_m) {
  ASSERT_EQ(motion.time.size(), arm.elbow.size());
  EXPECT_LT(rms(motion.shoulder, arm.shoulder), within_m);
  EXPECT_LT(rms(motion.elbow, arm.elbow), within_m);
  EXPECT_LT(rms(motion.wrist, arm.wrist), within_m);
}

TEST(FunctionalJoints, WithoutLandmarksAndStaticTrialTheMotionTells) {
  for (const std::size_t size : {3u, 4u}) {
    const MovingArm arm = moving_arm(size, false);
    const HumanMotion motion = reconstruct(arm.demonstration, {}, {});
    expect_all_seen(motion);
    expect_joints(motion, arm, 0.001);
    EXPECT_THAT(motion.estimated, ElementsAre("shoulder", "elbow", "wrist"));
    EXPECT_THAT(motion.reconstruction_notes,
                Contains(HasSubstr("elbow: estimated as the centre of rotation of RUAR and RLAR")));
    EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("hand: its axes need RFB")));
  }
}

TEST(FunctionalJoints, GapsAreCarriedByTheClusterBridgedOrLeft) {
  MovingArm arm = moving_arm(4, false);
  hide(arm, "RUAR2", 0, 35, 200);
  hide(arm, "RLAR1", 60, 80, 150);
  hide(arm, "RHAN3", 100, 300, 1000);
  const HumanMotion carried = reconstruct(arm.demonstration, {}, {});
  expect_all_seen(carried);
  expect_joints(carried, arm, 0.0015);  // where one of four is hidden, three carry the noise
  EXPECT_THAT(carried.reconstruction_notes,
              Contains("RHAN3: hidden in 300 of 1000 frames, for up to 3.01 s; filled in from its "
                       "cluster in 300"));

  arm = moving_arm(3, false);
  hide(arm, "RLAR1", 50, 8, 100);     // 0.09 s: bridged
  hide(arm, "RHAN2", 500, 30, 1000);  // left, and with it the hand
  const HumanMotion left = reconstruct(arm.demonstration, {}, {});
  // Noise of three markers 100 mm away remains; it is the centre that is found to a millimetre.
  expect_joints(left, arm, 0.0015);
  EXPECT_THAT(left.reconstruction_notes,
              Contains("RLAR1: hidden in 80 of 1000 frames, for up to 0.09 s; interpolated in 80"));
  EXPECT_THAT(left.reconstruction_notes,
              Contains("RHAN2: hidden in 30 of 1000 frames, for up to 0.31 s; missing in 30"));
  expect_all_seen(left);  // the forearm alone carries the wrist, without a step
  for (std::size_t i = 1; i < left.time.size(); ++i) {
    EXPECT_LT((left.wrist[i] - left.wrist[i - 1] - arm.wrist[i] + arm.wrist[i - 1]).norm(), 0.001);
  }
}

TEST(FunctionalJoints, LandmarksInTheRecordingAreTakenAsTheyAre) {
  MovingArm arm = moving_arm(3, true);
  hide(arm, "RLEP", 200, 100, 1000);
  hide(arm, "RSPU", 700, 150, 1000);
  const HumanMotion motion = reconstruct(arm.demonstration, {}, {});
  expect_all_seen(motion);
  expect_joints(motion, arm, 0.0005);
  EXPECT_THAT(motion.estimated, IsEmpty());
  EXPECT_THAT(motion.reconstruction_notes, Contains("RSPU: hidden in 150 of 1000 frames, for up to "
                                                    "1.51 s; filled in from its cluster in 150"));
  EXPECT_THAT(motion.reconstruction_notes, Not(Contains(HasSubstr("hand:"))));
  for (const Quat& orientation : motion.wrist_orientation) ASSERT_TRUE(is_known(orientation));
  EXPECT_EQ(motion.arm_angles.rows(), 1000);
}

TEST(FunctionalJoints, LandmarksAloneAreAnArm) {
  MovingArm arm = moving_arm(3, true);
  MarkerStream& markers = arm.markers();
  for (std::string& name : markers.names) {
    if (std::isdigit(name.back())) name = "other" + name;
  }
  const HumanMotion motion = reconstruct(arm.demonstration, {}, {});
  expect_all_seen(motion);
  expect_joints(motion, arm, 0.0005);
  for (const Quat& orientation : motion.wrist_orientation) ASSERT_TRUE(is_known(orientation));
}

TEST(FunctionalJoints, OneEpicondyleIsANearbyPlaceToLookAt) {
  MovingArm arm = moving_arm(4, true);
  arm.markers().names[arm.column("RMEP")] = "other";
  const HumanMotion motion = reconstruct(arm.demonstration, {}, {});
  EXPECT_THAT(motion.estimated, ElementsAre("elbow"));
  expect_joints(motion, arm, 0.001);
}

}  // namespace
}  // namespace morphe::reconstruct
