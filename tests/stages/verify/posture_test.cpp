#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stages/verify/posture_errors.hpp"
#include "tests/stages/verify/planar_plan.hpp"

namespace morphe::verify {
namespace {

/// The planar robot with the finger's first joint as its wrist and palm.
RobotModel robot_with_wrist() {
  RobotModel robot = planar::robot();
  robot.joint_centres = {{1, "arm"}, {2, "arm"}};
  robot.palm_frame = 2;
  return robot;
}

Vec3 at_angle(double angle, double length) {
  return length * Vec3(std::cos(angle), std::sin(angle), 0);
}

/// The planar plan of a person whose arm is the robot's, turned by `turn` about z and half as long.
Plan plan_of_a_smaller_person(double turn) {
  Plan plan = planar::plan();
  for (std::size_t k = 0; k < plan.goals.frames(); ++k) {
    const Eigen::Vector3d q = planar::position_at(static_cast<double>(k) / 80);
    plan.goals.shoulder_position[k] = Vec3(1, 1, 1);
    plan.goals.elbow_position[k] = Vec3(1, 1, 1) + at_angle(q(0) + turn, 0.15);
    plan.goals.wrist_position[k] =
        plan.goals.elbow_position[k] + at_angle(q(0) + q(1) + turn, 0.125);
    plan.goals.wrist_orientation[k] = Quat(Eigen::AngleAxisd(q.sum() + turn, Vec3::UnitZ()));
  }
  return plan;
}

Certificate recomputed(const RobotModel& robot, const Plan& plan) {
  Certificate own;
  recompute_posture(robot, plan, make_curve(plan.trajectory), own);
  return own;
}

TEST(RecomputePosture, ATurnedCopyOfTheRobot) {
  const Certificate own = recomputed(robot_with_wrist(), plan_of_a_smaller_person(0.3));
  // Goals between frames are interpolated linearly, which costs less than 1e-3 rad.
  EXPECT_NEAR(own.forearm_error_mean, 0.3, 1e-3);
  EXPECT_NEAR(own.forearm_error_max, 0.3, 1e-3);
  EXPECT_NEAR(own.palm_error_mean, 0.3, 1e-3);
  EXPECT_NEAR(own.palm_error_max, 0.3, 1e-3);
  EXPECT_NEAR(own.swivel_error_max, 0, 1e-9);
  EXPECT_NEAR(own.wrist_speed_correlation, 1, 1e-9);
}

TEST(RecomputePosture, AMirroredElbowIsHalfATurnAway) {
  Plan plan = plan_of_a_smaller_person(0);
  for (std::size_t k = 0; k < plan.goals.frames(); ++k) {
    const Vec3 line = (plan.goals.wrist_position[k] - plan.goals.shoulder_position[k]).normalized();
    const Vec3 upper_arm = plan.goals.elbow_position[k] - plan.goals.shoulder_position[k];
    plan.goals.elbow_position[k] += 2 * (line.dot(upper_arm) * line - upper_arm);
  }
  EXPECT_NEAR(recomputed(robot_with_wrist(), plan).swivel_error_mean, std::numbers::pi, 1e-6);
}

TEST(RecomputePosture, FiguresAreUnknownWithoutAnArmOrAPerson) {
  RobotModel hand = robot_with_wrist();
  hand.joint_centres.clear();
  const Certificate of_hand = recomputed(hand, plan_of_a_smaller_person(0.3));
  const Certificate of_nobody = recomputed(robot_with_wrist(), planar::plan());
  EXPECT_FALSE(std::isnan(of_hand.palm_error_mean));
  EXPECT_TRUE(std::isnan(of_nobody.palm_error_mean));
  for (const Certificate& own : {of_hand, of_nobody}) {
    EXPECT_TRUE(std::isnan(own.forearm_error_mean));
    EXPECT_TRUE(std::isnan(own.swivel_error_max));
    EXPECT_TRUE(std::isnan(own.wrist_speed_correlation));
  }
}

}  // namespace
}  // namespace morphe::verify
