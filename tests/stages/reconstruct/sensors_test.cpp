#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "stages/import/import.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A wrist that swings forward and turns slowly, with five fingertips fixed to it.
Demonstration tracked_hand() {
  Demonstration d;
  const std::size_t n = 200;
  BodyStream wrist{{"wrist"}, {}, {}, {n, 1, unknown_point()}, {n, 1, unknown_rotation()}};
  HandStream hand{HandKind::fingertips, {}, {}, {}, {n, 5, unknown_point()}};
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    wrist.time.push_back(t);
    wrist.position(i, 0) = Vec3(0.1, 0.2 * std::sin(t), 0.2 + 0.05 * t);
    Quat turn(Eigen::AngleAxisd(1.5 * std::sin(t), Vec3(1, 1, 0).normalized()));
    if (i % 2 == 1) turn.coeffs() *= -1;  // the same rotation
    wrist.orientation(i, 0) = turn;
    for (std::size_t f = 0; f < 5; ++f) {
      hand.position(i, f) =
          wrist.position(i, 0) + turn * Vec3(0.02, 0.02 * static_cast<double>(f), 0.1);
    }
  }
  hand.time = wrist.time;
  d.streams.sensors = wrist;
  d.streams.hand = hand;
  return d;
}

TEST(MotionFromSensors, KeepsWristAndTipsAndEstimatesTheArm) {
  const Demonstration d = tracked_hand();
  const HumanOptions human;
  const HumanMotion motion = reconstruct(d, {}, human);
  EXPECT_THAT(motion.estimated, ElementsAre("shoulder", "elbow"));
  EXPECT_THAT(
      motion.reconstruction_notes,
      testing::ElementsAre(testing::HasSubstr("the shoulder was not recorded: it is estimated"),
                           testing::HasSubstr("the elbow was not recorded: it is estimated")));
  ASSERT_EQ(motion.time.size(), 200u);
  const double upper_arm = 0.186 * kDefaultStature_m, forearm = 0.146 * kDefaultStature_m;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    EXPECT_LT((motion.wrist[i] - d.streams.sensors->position(i, 0)).norm(), 1e-3);
    EXPECT_LT(angle_between(motion.wrist_orientation[i], d.streams.sensors->orientation(i, 0)),
              5e-3);
    for (std::size_t f = 0; f < 5; ++f) {
      EXPECT_LT((motion.tip(i, f) - d.streams.hand->position(i, f)).norm(), 2e-3);
    }
    EXPECT_EQ(motion.shoulder[i], motion.shoulder[0]);
    EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), upper_arm, 1e-9);
    EXPECT_NEAR((motion.elbow[i] - motion.wrist[i]).norm(), forearm, 1e-9);
    EXPECT_LT(motion.elbow[i].z(), motion.shoulder[i].z());
  }
}

TEST(MotionFromSensors, SaysWhenNoShoulderReaches) {
  Demonstration d = tracked_hand();
  d.upper_arm = d.forearm = 0.02;
  const HumanMotion motion = reconstruct(d, {}, {});
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("no fixed shoulder")));
  EXPECT_FALSE(is_known(motion.shoulder[0]));
  EXPECT_FALSE(is_known(motion.elbow[0]));
  EXPECT_TRUE(is_known(motion.wrist[0]));
}

TEST(MotionFromSensors, TakesATrackedArm) {
  Demonstration d = tracked_hand();
  BodyStream& bodies = *d.streams.sensors;
  const BodyStream wrist = bodies;
  bodies.names = {"shoulder", "elbow", "wrist"};
  bodies.position = Array2D<Vec3>(200, 3, Vec3(0.2, -0.2, 0.4));
  bodies.orientation = Array2D<Quat>(200, 3, Quat::Identity());
  for (std::size_t i = 0; i < 200; ++i) {
    bodies.position(i, 1) = Vec3(0.25, -0.1, 0.1);
    bodies.position(i, 2) = wrist.position(i, 0);
  }
  const HumanMotion motion = reconstruct(d, {}, {});
  EXPECT_TRUE(motion.estimated.empty());
  EXPECT_LT((motion.shoulder[100] - Vec3(0.2, -0.2, 0.4)).norm(), 1e-9);
  EXPECT_LT((motion.elbow[100] - Vec3(0.25, -0.1, 0.1)).norm(), 1e-9);
}

TEST(MotionFromSensors, NothingRecordedIsAProblemNotAnError) {
  const HumanMotion motion = reconstruct({}, {}, {});
  EXPECT_TRUE(motion.time.empty());
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("no arm can be reconstructed")));
}

TEST(MotionFromSensors, RebuildsTheDoorDemonstrations) {
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) /
                   "datasets/adroit-dapg/recordings.yaml"};
  imports::import_recordings(request, [](Demonstration&& d) {
    const HumanMotion motion = reconstruct(d, {}, {});
    EXPECT_THAT(
        motion.reconstruction_notes,
        testing::ElementsAre(testing::HasSubstr("the shoulder was not recorded: it is estimated"),
                             testing::HasSubstr("the elbow was not recorded: it is estimated")))
        << motion.reconstruction_notes.front();
    EXPECT_THAT(motion.estimated, ElementsAre("shoulder", "elbow"));
    EXPECT_EQ(motion.time.size(), d.streams.sensors->time.size());
    double step = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      EXPECT_TRUE(is_known(motion.wrist[i]) && is_known(motion.elbow[i]));
      for (std::size_t f = 0; f < 5; ++f) EXPECT_TRUE(is_known(motion.tip(i, f)));
      if (i > 0) step = std::max(step, (motion.elbow[i] - motion.elbow[i - 1]).norm());
    }
    const Vec3& s = motion.shoulder[0];
    fmt::print("{}: shoulder ({:.3f} {:.3f} {:.3f}), elbow moves at most {:.1f} mm in 10 ms\n",
               d.name, s.x(), s.y(), s.z(), 1000 * step);
    EXPECT_LT(step, 0.03);
  });
}

TEST(ReconstructOptions, AreChecked) {
  EXPECT_EQ(validation_error(ReconstructOptions{}), "");
  ReconstructOptions options;
  options.cutoff_hz = 45;
  EXPECT_THAT(validation_error(options), HasSubstr("cutoff_hz"));
}

}  // namespace
}  // namespace morphe::reconstruct
