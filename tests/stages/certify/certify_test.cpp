#include "stages/certify/certify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stages/certify/goal_errors.hpp"
#include "stages/certify/trajectory_motion.hpp"
#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::certify {
namespace {

constexpr double kSweep = 0.5;

Vec3 turned(double angle, double x, double y) {
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Vec3(x, y, 0);
}

/// Goals that the sweep meets at both its ends but for `off`; the human's upper arm points 0.2 rad
/// to the left all the time.
Goals goals_off_by(const Vec3& off) {
  Goals goals;
  goals.time = {0, 0.8};
  goals.tip_position = Array2D<Vec3>(2, 2, unknown_point());
  goals.tip_orientation = Array2D<Quat>(2, 2, unknown_rotation());
  goals.reachable = Array2D<std::uint8_t>(2, 2, 1);
  for (const std::size_t frame : {0u, 1u}) {
    const double angle = frame == 0 ? 0 : kSweep;
    goals.tip_position(frame, 0) = turned(angle, 0.55, 0.04) + off;
    goals.tip_orientation(frame, 0) =
        Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()));
  }
  goals.shoulder_position = {Vec3::Zero(), Vec3::Zero()};
  goals.elbow_position = {turned(0.2, 0.3, 0), turned(0.2, 0.3, 0)};
  return goals;
}

struct Case {
  robot::Robot robot{planar_arm()};
  Scene scene;
  Movement movement;
  Goals goals = goals_off_by(Vec3::Zero());
  Trajectory trajectory = sweep(kSweep);
  MappingResult mapped;
  Tolerances tolerances;

  Case() {
    movement.end_s = 0.8;
    trajectory.demonstration_time = {0, 0.8};
    tolerances.tracking_tolerance =
        0.1;  // goals go straight and steadily from one end to the other
  }
  Outcome<Certificate> run() {
    const collision::CollisionWorld world =
        collision::make_world(robot, scene, movement, tolerances);
    return certify(world, goals, movement, trajectory, mapped);
  }
};

TEST(Certify, FiguresInClosedForm) {
  Case c;
  c.goals = goals_off_by(Vec3(0, 0, 0.001));
  c.scene.objects = {ball(Vec3(0.4, 0, 0.2), 0.05)};
  c.mapped.humanlikeness = JointRows::Zero(3, 3);
  c.mapped.humanlikeness.col(0) << 0.1, kUnknown, 0.3;
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::none) << result.failure.detail;
  const Certificate& k = result.value;
  // Minimum-jerk rest to rest: 15/8, 10/sqrt(3) and 60 times the way.
  EXPECT_NEAR(k.velocity_ratio, kSweep * 15 / 8, 1e-12);
  EXPECT_NEAR(k.acceleration_ratio, kSweep * 10 / std::sqrt(3.0) / 5, 1e-12);
  EXPECT_NEAR(k.jerk_ratio, kSweep, 1e-12);
  EXPECT_NEAR(k.joint_limit_margin, 2 - kSweep, 1e-12);
  EXPECT_LE(k.clearance, 0.2 - 0.05 - 0.03 + 1e-12);
  EXPECT_GE(k.clearance, 0.2 - 0.05 - 0.03 - 1e-5);
  EXPECT_NEAR(c.trajectory.clearance[0], 0.12, 1e-9);
  EXPECT_NEAR(k.tip_error_max, 0.001, 1e-12);
  EXPECT_NEAR(k.tip_error_mean, 0.001, 1e-12);
  EXPECT_TRUE(std::isnan(k.tip_error_grasp));
  EXPECT_NEAR(k.tip_orientation_error_max, 0.4, 1e-9);
  EXPECT_NEAR(k.upper_arm_error_max, 0.3, 1e-9);
  EXPECT_NEAR(k.upper_arm_error_mean, 0.25, 1e-9);
  EXPECT_NEAR(k.duration_ratio, 1 / 0.8, 1e-12);
  const auto chord = [](double angle) { return std::pow(0.6 * std::sin(angle / 2), 2); };
  EXPECT_NEAR(k.humanlikeness_final, 0.5 * (chord(0.2) + chord(0.3)), 1e-12);
  EXPECT_NEAR(k.humanlikeness_mapped, 0.2, 1e-12);
}

TEST(Certify, LimitBetweenSamplesIsFound) {
  Case c;
  c.robot.velocity[0] = 0.9 * kSweep * 15 / 8;  // both samples are at rest
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::joint_limit);
  EXPECT_THAT(result.failure.detail,
              testing::HasSubstr("velocity of joint shoulder is 1.1111 times"));
}

TEST(Certify, PositionBeyondItsLimit) {
  Case c;
  c.robot.upper[0] = kSweep - 0.01;
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::joint_limit);
  EXPECT_NEAR(result.value.joint_limit_margin, -0.01, 1e-12);
}

TEST(Certify, ContactBetweenSamplesIsFound) {
  Case c;
  // The forearm sweeps through a ball that is clear of it at both samples.
  c.scene.objects = {ball(turned(0.25, 0.5, 0), 0.02)};
  const Outcome<Certificate> result = c.run();
  EXPECT_GT(*std::min_element(c.trajectory.clearance.begin(), c.trajectory.clearance.end()), 0.03);
  EXPECT_NEAR(result.value.clearance, -0.05, 1e-5);
  EXPECT_EQ(result.failure.reason, Reason::smoothing_collision);
  EXPECT_THAT(result.failure.detail, testing::HasSubstr("forearm and ball"));
}

TEST(Certify, AMissByAHairIsProvedFree) {
  Case c;
  // At height 0.06 + margin + 0.2 mm above the sweep of the forearm's axis.
  c.scene.objects = {ball(turned(0.25, 0.5, 0) + Vec3(0, 0, 0.0612), 0.03)};
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::none);
  EXPECT_NEAR(result.value.clearance, 0.0012, 1e-5);
  // By less than the first resolution of the check, but more than the second.
  c.scene.objects = {ball(turned(0.25, 0.5, 0) + Vec3(0, 0, 0.06105), 0.03)};
  EXPECT_EQ(c.run().failure.reason, Reason::none);
  c.scene.objects = {ball(turned(0.25, 0.5, 0) + Vec3(0, 0, 0.0608), 0.03)};
  EXPECT_EQ(c.run().failure.reason, Reason::smoothing_collision);
}

TEST(Certify, TrackingIsTighterInTheGrasp) {
  Case c;
  c.goals = goals_off_by(Vec3(0, 0, 0.006));
  EXPECT_EQ(c.run().failure.reason, Reason::none);
  c.movement.phases = {{PhaseKind::reach, 0, 0.8, 1}, {PhaseKind::grasp, 0.8, 1, 1}};
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::tracking);
  EXPECT_THAT(result.failure.detail, testing::HasSubstr("thumb_tip is 6.00 mm"));
  EXPECT_NEAR(result.value.tip_error_grasp, 0.006, 1e-12);
}

TEST(Certify, ATipBetweenSamplesIsFound) {
  Case c;
  // The tip leaves its goal, which stands still, and comes back to it: accelerations of 16 rad/s^2
  // at both ends of a second make 2 * 16 / 64 rad in the middle.
  c.trajectory = sweep(0);
  c.trajectory.demonstration_time = {0, 0.8};
  c.trajectory.acceleration.col(0).setConstant(16);
  c.robot.acceleration.setConstant(100);
  c.robot.velocity.setConstant(10);
  c.robot.jerk.setConstant(1000);
  for (Vec3& goal : c.goals.tip_position.values)
    if (is_known(goal)) goal = turned(0, 0.55, 0.04);
  const double way = 2 * std::sin(0.25) * Vec3(0.55, 0.04, 0).norm();
  c.tolerances.tracking_tolerance = 1.001 * way;
  EXPECT_EQ(c.run().failure.reason, Reason::none) << c.run().failure.detail;
  c.tolerances.tracking_tolerance = 0.999 * way;
  const Outcome<Certificate> result = c.run();
  EXPECT_EQ(result.failure.reason, Reason::tracking);
  EXPECT_THAT(result.failure.detail,
              testing::HasSubstr("mm from its goal after sample 0 (0.500 s)"));
  EXPECT_NEAR(result.value.tip_error_max, 0, 1e-12);  // of samples
}

TEST(TrajectoryMotion, TravelBoundsTheMotion) {
  Trajectory t = sweep(kSweep);
  t.velocity(0, 1) = 0.4;  // the elbow swings out and back
  t.acceleration(1, 2) = -3;
  const collision::JointMotion motion = trajectory_motion(t);
  JointVector middle, q, travel;
  for (double s0 = 0; s0 < 0.9; s0 += 0.13) {
    const double s1 = s0 + 0.1;
    motion.position(0.5 * (s0 + s1), middle);
    motion.travel(s0, s1, travel);
    for (double s = s0; s <= s1; s += 0.004) {
      motion.position(s, q);
      for (Eigen::Index k = 0; k < 3; ++k) EXPECT_LE(std::abs(q[k] - middle[k]), travel[k] + 1e-15);
    }
  }
}

}  // namespace
}  // namespace morphe::certify
