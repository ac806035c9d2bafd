#include "tests/stages/reconstruct/gloved_arm.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/reconstruct/clock_offset.hpp"
#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kDegree = std::numbers::pi / 180;

/// Root mean square errors of a motion, its first and last 0.3 s left out.
struct Errors {
  double elbow = 0, wrist = 0, tips = 0;   ///< [m]
  double arm_angles = 0, hand_angles = 0;  ///< [rad]
  double wrist_late = 0, tips_late = 0;    ///< [s], by error against velocity
};

Errors errors_of(const HumanMotion& motion, const GlovedArm& truth) {
  Errors e;
  double n = 0, wrist_way = 0, tips_way = 0;
  for (std::size_t i = 30; i + 30 < motion.time.size(); ++i) {
    const double t = motion.time[i], step = 1e-4;
    const human::ArmPose pose = truth.pose(t);
    const Vec3 wrist_error = motion.wrist[i] - pose.wrist;
    const Vec3 wrist_speed = (truth.pose(t + step).wrist - truth.pose(t - step).wrist) / (2 * step);
    e.elbow += (motion.elbow[i] - pose.elbow).squaredNorm();
    e.wrist += wrist_error.squaredNorm();
    e.wrist_late -= wrist_error.dot(wrist_speed);
    wrist_way += wrist_speed.squaredNorm();
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const Vec3 error = motion.tip(i, f) - truth.tip(t, f);
      const Vec3 speed = (truth.tip(t + step, f) - truth.tip(t - step, f)) / (2 * step);
      e.tips += error.squaredNorm() / kFingerCount;
      e.tips_late -= error.dot(speed);
      tips_way += speed.squaredNorm();
    }
    const human::ArmAngles arm = truth.angles(t);
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < kArmAngleCount; ++k) {
      e.arm_angles += std::pow(motion.arm_angles(row, static_cast<Eigen::Index>(k)) - arm[k], 2) /
                      kArmAngleCount;
    }
    const human::HandAngles hand = truth.fingers(t);
    for (std::size_t k = 0; k < kHandAngleCount; ++k) {
      e.hand_angles +=
          std::pow(motion.hand_angles(row, static_cast<Eigen::Index>(k)) - hand.joint[k], 2) /
          kHandAngleCount;
    }
    ++n;
  }
  for (double* sum : {&e.elbow, &e.wrist, &e.tips, &e.arm_angles, &e.hand_angles}) {
    *sum = std::sqrt(*sum / n);
  }
  e.wrist_late /= wrist_way;
  e.tips_late /= tips_way;
  return e;
}

TEST(GlovedArm, IsRebuiltFromCleanSensors) {
  const GlovedArm truth;
  const HumanMotion motion = reconstruct(truth.record(), {}, {});
  EXPECT_THAT(motion.reconstruction_notes, IsEmpty());
  EXPECT_THAT(motion.estimated, IsEmpty());
  const Errors e = errors_of(motion, truth);
  EXPECT_LT(e.elbow, 0.0001);
  EXPECT_LT(e.wrist, 0.0001);
  EXPECT_LT(e.tips, 0.0003);
  EXPECT_LT(e.arm_angles, 0.1 * kDegree);
  EXPECT_LT(e.hand_angles, 0.1 * kDegree);
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), 0.30, 1e-4);
    EXPECT_NEAR((motion.wrist[i] - motion.elbow[i]).norm(), 0.25, 1e-4);
  }
  const auto middle = motion.time.size() / 2;
  const human::HandPoints points = truth.points(motion.time[middle]);
  const human::ArmPose pose = truth.pose(motion.time[middle]);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_LT((motion.finger_joint(middle, f) - pose.wrist -
               pose.world_from_hand * points.middle_joint[f])
                  .norm(),
              0.001);
    EXPECT_LT(angle_between(motion.tip_orientation(middle, f),
                            pose.world_from_hand * points.tip_orientation[f]),
              0.3 * kDegree);
  }
}

/// Published accuracies: 0.76 mm, 0.15 degrees, 1 degree.
TEST(GlovedArm, IsRebuiltFromNoisySensorsWithoutDelay) {
  GlovedArm truth;
  truth.position_noise = 0.00076;
  truth.rotation_noise = 0.15 * kDegree;
  truth.glove_noise = 1 * kDegree;
  const HumanMotion motion = reconstruct(truth.record(), {}, {});
  const Errors e = errors_of(motion, truth);
  fmt::print(
      "elbow {:.2f} mm, wrist {:.2f} mm, tips {:.2f} mm, arm {:.2f} deg, hand {:.2f} deg; "
      "late by {:.2f} ms (wrist), {:.2f} ms (tips)\n",
      1e3 * e.elbow, 1e3 * e.wrist, 1e3 * e.tips, e.arm_angles / kDegree, e.hand_angles / kDegree,
      1e3 * e.wrist_late, 1e3 * e.tips_late);
  EXPECT_LT(e.elbow, 0.0007);
  EXPECT_LT(e.wrist, 0.0007);
  EXPECT_LT(e.tips, 0.0020);
  EXPECT_LT(e.arm_angles, 0.5 * kDegree);
  EXPECT_LT(e.hand_angles, 0.7 * kDegree);
  EXPECT_LT(std::abs(e.wrist_late), 0.0005);
  EXPECT_LT(std::abs(e.tips_late), 0.001);
  // One length a bone in every frame, and near the true one.
  const double upper_arm = (motion.elbow[0] - motion.shoulder[0]).norm();
  const double forearm = (motion.wrist[0] - motion.elbow[0]).norm();
  EXPECT_NEAR(upper_arm, 0.30, 0.0002);
  EXPECT_NEAR(forearm, 0.25, 0.0002);
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), upper_arm, 1e-9);
    EXPECT_NEAR((motion.wrist[i] - motion.elbow[i]).norm(), forearm, 1e-9);
  }
}

TEST(GlovedArm, AGlovesClockIsCorrectedByTheWrist) {
  GlovedArm truth;
  truth.position_noise = 0.00076;
  truth.rotation_noise = 0.15 * kDegree;
  truth.glove_noise = 1 * kDegree;
  for (const double late : {-0.31, 0.123}) {
    truth.glove_late_s = late;
    const HumanMotion motion = reconstruct(truth.record(), {}, {});
    EXPECT_THAT(motion.reconstruction_notes,
                ElementsAre(HasSubstr(late > 0 ? "ahead of" : "behind")));
    double tips = 0;
    std::size_t count = 0;
    for (std::size_t i = 100; i + 100 < motion.time.size(); ++i, ++count) {
      tips += (motion.tip(i, 1) - truth.tip(motion.time[i], 1)).squaredNorm();
    }
    EXPECT_LT(std::sqrt(tips / static_cast<double>(count)), 0.0025);
  }
  ReconstructOptions as_it_is;
  as_it_is.align_clocks = false;
  const HumanMotion motion = reconstruct(truth.record(), as_it_is, {});
  EXPECT_THAT(motion.reconstruction_notes, IsEmpty());
  EXPECT_GT(errors_of(motion, truth).tips, 0.005);
}

TEST(GlovedArm, ALeftArmIsTheMirroredRightOne) {
  const Demonstration right = GlovedArm{}.record();
  Demonstration left = mirror_image(right);
  left.hand = Side::left;
  const HumanMotion a = reconstruct(right, {}, {}), b = reconstruct(left, {}, {});
  ASSERT_EQ(a.time.size(), b.time.size());
  for (std::size_t i = 50; i < a.time.size(); i += 50) {
    EXPECT_LT((a.elbow[i] - b.elbow[i]).norm(), 1e-12);
    EXPECT_LT((a.tip(i, 1) - b.tip(i, 1)).norm(), 1e-12);
  }
}

TEST(GlovedArm, AGloveOf18SensorsBendsTheLastJointsWithTheMiddleOnes) {
  Demonstration d = GlovedArm{}.record();
  for (const Eigen::Index last : {6, 9, 13, 17})
    d.streams.hand->angles.col(last).setConstant(kUnknown);
  const HumanMotion motion = reconstruct(d, {}, {});
  EXPECT_THAT(motion.estimated, ElementsAre("glove sensor IndexDIJ", "glove sensor MiddleDIJ",
                                            "glove sensor RingDIJ", "glove sensor PinkieDIJ"));
  EXPECT_NEAR(motion.hand_angles(300, 7), motion.hand_angles(300, 6) * 2 / 3, 1e-12);
  EXPECT_TRUE(is_known(motion.tip(300, 1)));
  d.streams.hand->angles.col(4).setConstant(
      kUnknown);  // the index' knuckle: nothing makes up for it
  const HumanMotion without = reconstruct(d, {}, {});
  EXPECT_FALSE(is_known(without.tip(300, 1)));
  EXPECT_TRUE(is_known(without.tip(300, 2)));
}

TEST(GlovedArm, EitherMayComeAlone) {
  const GlovedArm truth;
  Demonstration glove = truth.record();
  glove.streams.sensors.reset();
  HumanMotion motion = reconstruct(glove, {}, {});
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("no body named wrist")));
  EXPECT_NEAR(motion.hand_angles(300, 5), truth.fingers(motion.time[300]).joint[5], 1e-3);
  EXPECT_FALSE(is_known(motion.tip(300, 1)));
  Demonstration arm = truth.record();
  arm.streams.hand.reset();
  motion = reconstruct(arm, {}, {});
  EXPECT_THAT(motion.reconstruction_notes, ElementsAre(HasSubstr("no fingertips")));
  EXPECT_TRUE(is_known(motion.wrist[300]));
  EXPECT_EQ(motion.hand_angles.rows(), 0);
}

TEST(GlovedArm, OddRecordingsAreSaid) {
  Demonstration d = GlovedArm{}.record();
  for (double& t : d.streams.hand->time) t += 1e6;
  HumanMotion motion = reconstruct(d, {}, {});
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("do not overlap in time")));
  EXPECT_EQ(motion.time.size(), 1000u);
  d = GlovedArm{}.record();
  d.sensor_offsets->sensors[1] = "knee";
  d.calibration = {};
  d.hand_length.reset();
  motion = reconstruct(d, {}, {});
  EXPECT_THAT(motion.reconstruction_notes,
              Contains(HasSubstr("the sensor elbow was not calibrated")));
  EXPECT_THAT(motion.reconstruction_notes, Contains(HasSubstr("no flat hand was recorded")));
  EXPECT_THAT(motion.estimated, ElementsAre("hand length"));
  d = GlovedArm{}.record();
  for (Vec3& point : d.streams.sensors->position.values) point = unknown_point();
  d.streams.hand->angles.setConstant(kUnknown);
  motion = reconstruct(d, {}, {});
  EXPECT_FALSE(is_known(motion.wrist[300]));
  EXPECT_EQ(motion.arm_angles.rows(), 0);
}

TEST(ClockOffset, FindsAShiftBetweenSamples) {
  for (const double late : {-0.234, 0.0, 0.0517}) {
    PairedSignal signal;
    for (int i = 0; i < 800; ++i) {
      const auto at = [](double t) { return std::sin(5 * t) + 0.3 * std::sin(11 * t + 1); };
      signal.reference.push_back(at(0.01 * i));
      signal.other.push_back(2 * at(0.01 * i - late) + 5 + 0.02 * i);
    }
    signal.other[100] = signal.reference[200] = kUnknown;
    const ClockOffset offset = clock_offset({signal}, 100, 8);
    EXPECT_NEAR(offset.offset_s, late, 0.0005);
    EXPECT_TRUE(is_reliable(offset));
  }
}

TEST(ClockOffset, IsNotClearWithoutACommonMovement) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  PairedSignal noise, still;
  for (int i = 0; i < 800; ++i) {
    noise.reference.push_back(normal(random));
    noise.other.push_back(normal(random));
    still.reference.push_back(1);
    still.other.push_back(1);
  }
  EXPECT_FALSE(is_reliable(clock_offset({noise}, 100, 8)));
  EXPECT_FALSE(is_reliable(clock_offset({still}, 100, 8)));
  EXPECT_FALSE(is_reliable(clock_offset({}, 100, 8)));
  EXPECT_FALSE(is_reliable(clock_offset({{{}, {}}}, 100, 8)));
}

}  // namespace
}  // namespace morphe::reconstruct
