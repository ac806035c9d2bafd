#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stages/certify/posture_errors.hpp"
#include "stages/certify/wrist_speed.hpp"
#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::certify {
namespace {

constexpr double kBend = 0.8;  ///< of the robot's elbow [rad]

/// The planar arm with its third frame, at the forearm's end, as wrist and palm.
robot::Robot arm_with_wrist() {
  RobotModel model = planar_arm();
  model.joint_centres = {{1, "arm"}, {2, "arm"}};
  model.palm_frame = 2;
  return robot::Robot(std::move(model));
}

Trajectory bent_sweep(double angle) {
  Trajectory trajectory = sweep(angle);
  trajectory.position.col(1).setConstant(kBend);
  return trajectory;
}

Vec3 in_plane(double angle, double length) {
  return length * Vec3(std::cos(angle), std::sin(angle), 0);
}

/// A person of 0.28 and 0.25 m who keeps these directions, and a hand turned by `hand` about z.
Goals still_person(double upper_arm, double forearm, double hand) {
  Goals goals;
  goals.time = {0, 1};
  for (int frame = 0; frame < 2; ++frame) {
    goals.shoulder_position.emplace_back(1, 2, 3);
    goals.elbow_position.push_back(Vec3(1, 2, 3) + in_plane(upper_arm, 0.28));
    goals.wrist_position.push_back(goals.elbow_position.back() + in_plane(forearm, 0.25));
    goals.wrist_orientation.emplace_back(Eigen::AngleAxisd(hand, Vec3::UnitZ()));
  }
  return goals;
}

Certificate errors_of(const Goals& goals, const Trajectory& trajectory) {
  Certificate certificate;
  set_posture_errors(arm_with_wrist(), goals, trajectory, certificate);
  return certificate;
}

TEST(PostureErrors, AnglesOfAPlanarArmInClosedForm) {
  // The robot's forearm points at 0.8 and 1.3 rad, and so does its palm.
  const Certificate c = errors_of(still_person(0.2, 1.0, 0.7), bent_sweep(0.5));
  EXPECT_NEAR(c.forearm_error_max, 0.3, 1e-12);
  EXPECT_NEAR(c.forearm_error_mean, 0.25, 1e-12);
  EXPECT_NEAR(c.palm_error_max, 0.6, 1e-12);
  EXPECT_NEAR(c.palm_error_mean, 0.35, 1e-12);
  EXPECT_NEAR(c.swivel_error_max, 0, 1e-12) << "both elbows are bent to the same side";
}

TEST(PostureErrors, AnElbowOnTheOtherSideIsTurnedByHalfATurn) {
  const Certificate c = errors_of(still_person(0.2, -0.6, 0), bent_sweep(0.5));
  EXPECT_NEAR(c.swivel_error_max, std::numbers::pi, 1e-12);
  EXPECT_NEAR(c.swivel_error_mean, std::numbers::pi, 1e-12);
}

TEST(PostureErrors, PointsThatWereNotRecordedLeaveTheFiguresUnknown) {
  Goals goals = still_person(0.2, 1.0, 0.7);
  goals.wrist_orientation.assign(2, unknown_rotation());
  goals.elbow_position[1] = unknown_point();
  const Certificate c = errors_of(goals, bent_sweep(0.5));
  EXPECT_TRUE(std::isnan(c.palm_error_mean));
  EXPECT_NEAR(c.forearm_error_mean, 0.2, 1e-12) << "of the first sample alone";
}

TEST(PostureErrors, AHandAloneHasNoArm) {
  RobotModel model = planar_arm();
  model.joint_centres = {{2, "index"}};
  Certificate c;
  set_posture_errors(robot::Robot(model), still_person(0.2, 1.0, 0.7), bent_sweep(0.5), c);
  EXPECT_TRUE(std::isnan(c.forearm_error_mean));
  EXPECT_TRUE(std::isnan(c.swivel_error_mean));
  EXPECT_TRUE(std::isnan(
      wrist_speed_correlation(robot::Robot(model), still_person(0, 1, 0), bent_sweep(0.5))));
}

double minimum_jerk_share(double share) {
  return share * share * share * (10 - 15 * share + 6 * share * share);
}

/// 81 frames of 10 ms in which the person's wrist turns by 0.5 rad about z, as minimum jerk.
Goals turning_person() {
  Goals goals;
  for (int frame = 0; frame <= 80; ++frame) {
    goals.time.push_back(0.01 * frame);
    goals.wrist_position.push_back(Vec3(0, 0, 1) +
                                   in_plane(0.5 * minimum_jerk_share(frame / 80.0), 0.4));
  }
  return goals;
}

TEST(WristSpeed, TheSameProfileCorrelatesFullyAtAnyTempoAndSize) {
  Trajectory trajectory = bent_sweep(0.5);
  trajectory.demonstration_time = {0, 0.8};
  EXPECT_NEAR(wrist_speed_correlation(arm_with_wrist(), turning_person(), trajectory), 1, 1e-9);
}

TEST(WristSpeed, APauseAndAnotherProfileCorrelateLess) {
  Goals goals = turning_person();
  Trajectory trajectory = bent_sweep(0.5);
  trajectory.demonstration_time = {0, 0.8};
  Trajectory pausing = trajectory;  // rests for 1 s at its end, which counts before the last frame
  for (auto* rows : {&pausing.position, &pausing.velocity, &pausing.acceleration}) {
    rows->conservativeResize(4, Eigen::NoChange);
    rows->row(2) = rows->row(1);
    rows->row(3) = rows->row(1);
  }
  pausing.time = {0, 1, 2, 3};
  pausing.demonstration_time = {0, 0.4, 0.4, 0.8};
  const double r = wrist_speed_correlation(arm_with_wrist(), goals, pausing);
  EXPECT_LT(r, 0.8);
  // A person who moves only while the robot is slow.
  for (int frame = 0; frame <= 80; ++frame) {
    const double share = frame / 80.0;
    goals.wrist_position[frame] = in_plane(share - minimum_jerk_share(share), 0.4);
  }
  EXPECT_LT(wrist_speed_correlation(arm_with_wrist(), goals, trajectory), 0.5);
}

TEST(WristSpeed, UnknownFramesDoNotCountAndAStillWristHasNoProfile) {
  Goals goals = turning_person();
  Trajectory trajectory = bent_sweep(0.5);
  trajectory.demonstration_time = {0, 0.8};
  for (int frame = 30; frame < 50; ++frame) goals.wrist_position[frame] = unknown_point();
  EXPECT_NEAR(wrist_speed_correlation(arm_with_wrist(), goals, trajectory), 1, 1e-9);
  goals.wrist_position.assign(81, Vec3(1, 2, 3));
  EXPECT_TRUE(std::isnan(wrist_speed_correlation(arm_with_wrist(), goals, trajectory)));
}

}  // namespace
}  // namespace morphe::certify
