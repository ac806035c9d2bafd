#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "planar_plan.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

std::vector<Violation> verify(const Plan& plan, const RobotModel& robot = planar::robot()) {
  return verify_plan(robot, "reach/000", plan);
}

std::vector<Violation> of(const std::string& cause, const std::vector<Violation>& violations) {
  std::vector<Violation> found;
  for (const Violation& violation : violations)
    if (violation.cause == cause) found.push_back(violation);
  return found;
}

SceneObject& object(Plan& plan, const std::string& name) {
  for (SceneObject& candidate : plan.scene.objects)
    if (candidate.name == name) return candidate;
  throw std::logic_error(name);
}

/// An arm at rest between two ways of the shoulder whose jerk is zero at the samples 0 and 1 and
/// 10 p / h^3 half-way between them, and at most 8.9 p / h^3 from there on (p = 0.01, h = 0.5).
Plan jerk_between_samples() {
  Plan plan = planar::plan();
  Trajectory& trajectory = plan.trajectory;
  constexpr double p = 0.01, h = 0.5;
  trajectory.time = {0, h, 4 * h};
  trajectory.demonstration_time = {2.0, 2.4, 2.8};
  trajectory.phase = std::vector<PhaseKind>(3, PhaseKind::reach);
  trajectory.origin = std::vector<SampleOrigin>(3, SampleOrigin::mapped);
  trajectory.clearance = {0, 0, 0};
  const Eigen::RowVector3d start = planar::position_at(0).transpose();
  trajectory.position = start.replicate(3, 1);
  trajectory.velocity = trajectory.acceleration = JointRows::Zero(3, 3);
  trajectory.position.col(0) += Eigen::Vector3d(0, p, 12 * p);
  trajectory.velocity(1, 0) = 10 * p / 3 / h;
  trajectory.acceleration(1, 0) = 20 * p / 3 / (h * h);
  return plan;
}

TEST(VerifyPlan, ABranchIsThatOfTheTrajectory) {
  RobotModel robot = planar::robot();
  robot.palm_frame = 3;  // the distal link, beyond shoulder, elbow and proximal joint
  Plan plan = planar::plan();
  plan.branch.number = 0;  // the elbow is bent by 0.5 to 0.9 rad
  EXPECT_TRUE(of("branch", verify(plan, robot)).empty());
  plan.branch.number = 2;
  const std::vector<Violation> found = of("branch", verify(plan, robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "elbow");
  EXPECT_EQ(found[0].value, 1);
  EXPECT_EQ(found[0].limit, 0);
}

TEST(VerifyPlan, AcceptsAValidPlan) {
  for (const Violation& v : verify(planar::plan()))
    ADD_FAILURE() << v.sample << " " << v.cause << " " << v.subject << " " << v.value << " "
                  << v.limit;
  EXPECT_TRUE(verify(planar::plan(0.001)).empty());
}

TEST(VerifyPlan, FindsAJointOverItsLimit) {
  Plan plan = planar::plan();
  plan.trajectory.position(50, 1) = 1.6;
  const auto found = of("position", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].plan, "reach/000");
  EXPECT_EQ(found[0].subject, "elbow");
  EXPECT_EQ(found[0].sample, 50);
  EXPECT_NEAR(found[0].time_s, 0.5, 0.005);
  EXPECT_GE(found[0].value, 1.6);
  EXPECT_EQ(found[0].limit, 1.5);
}

TEST(VerifyPlan, FindsARaisedVelocity) {
  Plan plan = planar::plan();
  plan.trajectory.velocity(30, 0) = -2.5;
  const auto found = of("velocity", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "shoulder");
  EXPECT_NEAR(found[0].sample, 30, 1);
  EXPECT_GE(found[0].value, 2.5);
  EXPECT_EQ(found[0].limit, 2);
}

/// The distal link of the planar arm copies the proximal one: 0.3 … 0.6 rad, 0.1 more than that.
RobotModel with_coupled_limit(const RobotModel::CoupledLimit& limit) {
  RobotModel robot = planar::robot();
  robot.coupled_limits = {limit};
  return robot;
}

TEST(VerifyPlan, FindsACoupledJointBeyondItsOwnLimits) {
  const Plan plan = planar::plan();
  const std::string distal = planar::robot().frames[3].name;
  RobotModel::CoupledLimit limit;
  limit.frame = 3;
  limit.lower = 0.29;
  limit.upper = 0.61;
  EXPECT_TRUE(verify(plan, with_coupled_limit(limit)).empty());
  limit.upper = 0.59;
  auto found = of("position", verify(plan, with_coupled_limit(limit)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, distal);
  EXPECT_NEAR(found[0].value, 0.6, 1e-12);
  EXPECT_EQ(found[0].limit, 0.59);
  limit.upper = 0.61;
  limit.velocity = 0.3 * 15 / 8 - 1e-3;  // minimum jerk over 0.3 rad in 1 s: 15/8 of the mean
  found = of("velocity", verify(plan, with_coupled_limit(limit)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, distal);
  EXPECT_NEAR(found[0].value, 0.3 * 15 / 8, 1e-6);
}

TEST(VerifyPlan, FindsAJointFasterThanItsBrakingCurve) {
  const Plan plan = planar::plan();
  RobotModel robot = planar::robot();
  // 15 rad/s are left everywhere but next to 0.72 rad, where the shoulder stops at 0.7.
  robot.braking_curves = {{0, 1000, 0, -9, 0.72}};
  EXPECT_TRUE(verify(plan, robot).empty());
  robot.braking_curves = {{0, 2, 0.3, -9, 0.72}};
  const auto found = of("velocity", verify(plan, robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "shoulder");
  const double q =
      0.2 + 0.5 * [](double s) { return s * s * s * (10 + s * (6 * s - 15)); }(found[0].time_s);
  EXPECT_NEAR(found[0].limit, std::max(0.0, std::sqrt(2 * (0.72 - q)) - 0.3), 1e-6);
}

TEST(VerifyPlan, FindsAClearanceThatNothingWasMeasuredFor) {
  Plan plan = planar::plan();
  RobotModel robot = planar::robot();
  robot.capsules.clear();
  robot.allowed_collision_pairs.clear();
  std::erase_if(plan.scene.objects, [](const SceneObject& one) { return one.name != "cup"; });
  plan.certificate.clearance = kUnknown;
  for (double& clearance : plan.trajectory.clearance) clearance = kUnknown;
  EXPECT_TRUE(verify(plan, robot).empty());
  plan.certificate.clearance = std::numeric_limits<double>::infinity();
  ASSERT_EQ(of("certificate", verify(plan, robot)).size(), 1u);
  plan.certificate.clearance = kUnknown;
  robot.unchecked_links = {"upper"};
  const auto found = of("certificate", verify(plan, robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "unchecked_links");
}

TEST(VerifyPlan, FindsAnEndThatIsNotAtRest) {
  Plan plan = planar::plan();
  plan.trajectory.acceleration(100, 2) = 0.01;
  const auto found = of("rest", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "proximal");
  EXPECT_EQ(found[0].sample, 100);
  EXPECT_EQ(found[0].value, 0.01);
}

TEST(VerifyPlan, FindsAnObstacleMovedIntoThePath) {
  Plan plan = planar::plan();
  object(plan, "bottle").position[0] = planar::tip_at(planar::position_at(0.5));
  const auto violations = verify(plan);
  bool distal = false;
  for (const Violation& v : of("object_collision", violations)) {
    if (v.subject != "distal/bottle") continue;
    distal = true;
    EXPECT_EQ(v.sample, 50);
    EXPECT_NEAR(v.value, -0.02 - 0.01, 1e-4);  // the axis goes through the bottle's
    EXPECT_EQ(v.limit, 0.001);
  }
  EXPECT_TRUE(distal);
}

TEST(VerifyPlan, FindsAThinObstacleBetweenTwoSamples) {
  Plan plan = planar::plan(0.1);
  SceneObject& rod = object(plan, "rod");
  rod.position[0] = planar::tip_at(planar::position_at(0.53));
  for (const double t : {0.5, 0.6})  // clear at both samples around
    ASSERT_GT((planar::tip_at(planar::position_at(t)) - rod.position[0]).norm(), 0.02);
  const auto found = of("object_collision", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "distal/rod");
  EXPECT_THAT(found[0].sample, testing::AnyOf(5, 6));
  EXPECT_NEAR(found[0].time_s, 0.53, 0.03);
}

TEST(VerifyPlan, FindsAnObstacleThatCrossesBetweenTwoSamples) {
  Plan plan = planar::plan(0.1);
  SceneObject& rod = object(plan, "rod");  // flies through the waiting arm within 2 ms
  rod.time = {2.0, 2.001, 2.003};
  rod.position = {Vec3(0.3, -0.8, 0.2), Vec3(0.3, -0.8, 0.2), Vec3(0.3, 0.8, 0.2)};
  rod.orientation = std::vector<Quat>(3, Quat::Identity());
  const auto found = of("object_collision", verify(plan));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].sample, 0);
  EXPECT_NEAR(found[0].time_s, 0.002 / 0.8, 0.00125);
}

/// Half way, the cup lies 2 mm deep against the distal link on the side to which it turns, and is
/// carried on; touching is allowed from 2.35 s.
Plan carrying(double touch_end_s) {
  Plan plan = planar::plan();
  const Eigen::Vector3d half = planar::position_at(0.5);
  const double direction = half.sum() + half(2) + 0.1;
  const Vec3 along(std::cos(direction), std::sin(direction), 0);
  SceneObject& cup = object(plan, "cup");
  cup.position[0] = planar::tip_at(half) - 0.03 * along + 0.038 * Vec3::UnitZ().cross(along);
  cup.attached_frame = "distal";
  cup.attach_s = 2.4;
  cup.release_s = 2.7;
  plan.movement.phases = {{PhaseKind::reach, 2.0, 2.35, 1},
                          {PhaseKind::grasp, 2.35, touch_end_s, 1}};
  return plan;
}

TEST(VerifyPlan, WhatIsCarriedStaysInTheHand) {
  Plan plan = carrying(2.8);
  EXPECT_TRUE(of("object_collision", verify(plan)).empty());
  // Left where it lay, the finger turns into it.
  object(plan, "cup").attached_frame = "";
  const auto left = of("object_collision", verify(plan));
  ASSERT_FALSE(left.empty());
  EXPECT_LT(left[0].value, -0.01);
  // A few millimetres deep all the while is too deep once nothing may touch it.
  const auto found = of("object_collision", verify(carrying(2.5)));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].subject, "distal/cup");
  EXPECT_LT(found[0].value, -0.001);
  EXPECT_GT(found[0].value, -0.005);
  EXPECT_GT(found[0].sample, 60);
}

TEST(VerifyPlan, WhatWasReleasedStaysThere) {
  Plan plan = carrying(2.8);
  // Recorded to be pulled through the forearm afterwards; but the robot has put it down elsewhere.
  SceneObject& cup = object(plan, "cup");
  cup.time = {2.0, 2.75, 2.8};
  cup.position = {cup.position[0], cup.position[0], Vec3(0.2, 0.25, 0.1)};
  cup.orientation = std::vector<Quat>(3, Quat::Identity());
  for (const Violation& violation : of("object_collision", verify(plan))) {
    EXPECT_EQ(violation.subject, "distal/cup") << violation.sample;
  }
  cup.attached_frame = "";
  EXPECT_FALSE(of("object_collision", verify(plan)).empty());
}

TEST(VerifyPlan, FindsAGoalMovedAtTheGrasp) {
  Plan plan = planar::plan();
  plan.goals.tip_position(75, 1).z() += 0.008;  // 2.75 s; sample 94 is at 2.752 s
  plan.goals.tip_position(40, 1).z() += 0.008;  // in the reach 20 mm are tolerated
  const auto found = of("tracking", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "index");
  EXPECT_EQ(found[0].sample, 94);
  EXPECT_GT(found[0].value, 0.0065);  // nearer to the frame than the sample is
  EXPECT_LT(found[0].value, 0.0081);
  EXPECT_EQ(found[0].limit, 0.005);
}

TEST(VerifyPlan, AsksNothingWhereATipWasNotSeen) {
  Plan plan = planar::plan();
  plan.goals.tip_position(75, 1).z() += 0.008;
  plan.goals.tip_position(74, 1) = plan.goals.tip_position(76, 1) = unknown_point();
  EXPECT_TRUE(of("tracking", verify(plan)).empty());
}

TEST(VerifyPlan, FindsJerkThatIsExceededOnlyBetweenSamples) {
  RobotModel robot = planar::robot();
  robot.jerk(0) = 0.76;
  const auto found = of("jerk", verify(jerk_between_samples(), robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "shoulder");
  EXPECT_THAT(found[0].sample, testing::AnyOf(0, 1));
  EXPECT_NEAR(found[0].time_s, 0.25, 1e-9);
  EXPECT_NEAR(found[0].value, 0.8, 1e-9);
  robot.jerk(0) = 0.81;
  EXPECT_TRUE(of("jerk", verify(jerk_between_samples(), robot)).empty());
}

TEST(VerifyPlan, FindsAFalseCertificate) {
  const std::pair<const char*, double Certificate::*> attributes[] = {
      {"joint_limit_margin", &Certificate::joint_limit_margin},
      {"velocity_ratio", &Certificate::velocity_ratio},
      {"acceleration_ratio", &Certificate::acceleration_ratio},
      {"jerk_ratio", &Certificate::jerk_ratio},
      {"clearance", &Certificate::clearance},
      {"tip_error_max", &Certificate::tip_error_max},
      {"tip_error_mean", &Certificate::tip_error_mean},
      {"tip_error_grasp", &Certificate::tip_error_grasp},
      {"sparc_robot", &Certificate::sparc_robot},
      {"sparc_human", &Certificate::sparc_human},
      {"log_dimensionless_jerk_robot", &Certificate::log_dimensionless_jerk_robot},
      {"log_dimensionless_jerk_human", &Certificate::log_dimensionless_jerk_human},
      {"duration_ratio", &Certificate::duration_ratio}};
  for (const auto& [name, attribute] : attributes) {
    for (const bool missing : {false, true}) {
      Plan plan = planar::plan();
      plan.certificate.*attribute = missing ? kUnknown : plan.certificate.*attribute + 0.001;
      const auto found = verify(plan);
      ASSERT_EQ(found.size(), 1u) << name;
      EXPECT_EQ(found[0].cause, "certificate");
      EXPECT_EQ(found[0].subject, name);
      EXPECT_EQ(found[0].sample, -1);
    }
  }
}

TEST(VerifyPlan, LetsOnlyAllowedCapsulesTouchTheTargetAndOnlyInTime) {
  Plan plan = planar::plan();
  plan.movement.target = "";
  auto found = of("object_collision", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "distal/cup");
  EXPECT_EQ(found[0].sample, 100);
  EXPECT_NEAR(found[0].value, -0.002, 1e-9);
  EXPECT_EQ(found[0].limit, 0.001);

  RobotModel robot = planar::robot();
  robot.capsules[3].may_touch_target = false;
  EXPECT_EQ(of("object_collision", verify(planar::plan(), robot)).size(), 1u);

  plan = planar::plan();
  plan.movement.phases.back().end_s = 2.79;  // lets go while still touching
  EXPECT_EQ(of("object_collision", verify(plan)).size(), 1u);

  plan = planar::plan();
  plan.tolerances.max_penetration = 0.0019;
  found = of("object_collision", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].limit, -0.0019);
}

TEST(VerifyPlan, LinksThatAreNoPadsHaveADepthOfTheirOwn) {
  RobotModel robot = planar::robot();
  RobotModel::Capsule knuckle = robot.capsules[3];  // ends before the distal link does
  knuckle.name = "knuckle";
  knuckle.to -= 0.001 * (knuckle.to - knuckle.from).normalized();
  robot.capsules.push_back(knuckle);
  Plan plan = planar::plan();
  EXPECT_TRUE(of("object_collision", verify(plan, robot)).empty());
  plan.tolerances.max_link_penetration = 0.0005;
  const auto found = of("object_collision", verify(plan, robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "knuckle/cup");
  EXPECT_EQ(found[0].limit, -0.0005);
  EXPECT_NEAR(found[0].value, -0.001, 1e-4);
}

TEST(VerifyPlan, FindsTheRobotInItsOwnWay) {
  RobotModel robot = planar::robot();
  robot.capsules[3].to = Vec3(-0.1, 0, 0);  // the distal link reaches back into the forearm
  const auto found = of("self_collision", verify(planar::plan(), robot));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "forearm/distal");
  robot.allowed_collision_pairs.push_back({1, 3});
  EXPECT_TRUE(of("self_collision", verify(planar::plan(), robot)).empty());
}

TEST(VerifyPlan, FindsTimeThatRunsBackOrLeavesGoalsOut) {
  Plan plan = planar::plan();
  plan.trajectory.time[10] = plan.trajectory.time[9];
  ASSERT_EQ(verify(plan).size(), 1u);
  EXPECT_EQ(verify(plan)[0].cause, "time");
  EXPECT_EQ(verify(plan)[0].sample, 10);

  plan = planar::plan();
  plan.trajectory.demonstration_time[20] = 2.1;
  EXPECT_EQ(verify(plan).at(0).subject, "demonstration_time");

  plan = planar::plan();
  for (double& time_s : plan.trajectory.demonstration_time) time_s = 2.0;  // stands still
  const auto found = of("time", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].limit, 2.8);
}

TEST(VerifyPlan, FindsWhatIsNotANumber) {
  Plan plan = planar::plan();
  plan.trajectory.velocity(3, 1) = kUnknown;
  EXPECT_EQ(verify(plan).at(0).cause, "finite");
  plan = planar::plan();
  object(plan, "cup").position[0].x() = kUnknown;
  EXPECT_EQ(verify(plan).at(0).subject, "cup");
}

TEST(VerifyPlan, FindsStatusAndContentApart) {
  Plan plan = planar::plan();
  plan.reason = Reason::smoothing_collision;
  EXPECT_EQ(of("structure", verify(plan)).size(), 2u) << "a trajectory and a grasp";
  plan.trajectory = {};
  plan.certificate = {};
  plan.grasp = {};
  EXPECT_TRUE(verify(plan).empty());
  plan.reason = Reason::none;
  EXPECT_EQ(verify(plan).at(0).cause, "structure");
  plan = planar::plan();
  object(plan, "bottle").shape = Shape::mesh;  // nothing that could be judged
  EXPECT_EQ(verify(plan).at(0).subject, "bottle");
}

TEST(VerifyPlan, JudgesTheApproachToo) {
  Plan plan = planar::plan();
  plan.approach = plan.trajectory;
  for (double& time_s : plan.approach.demonstration_time) time_s = 2.0;
  for (PhaseKind& phase : plan.approach.phase) phase = PhaseKind::rest;
  auto found = verify(plan);
  std::erase_if(found, [](const Violation& v) { return v.cause == "clearance"; });
  ASSERT_EQ(found.size(), 2u);  // it does not end where the trajectory begins, and meets the cup
  EXPECT_EQ(found[0].plan, "reach/000/approach");
  EXPECT_EQ(found[0].subject, "approach");
  EXPECT_EQ(found[1].subject, "distal/cup");
  // A clock inside of the grasp would let it touch.
  for (double& time_s : plan.approach.demonstration_time) time_s = 2.65;
  found = of("approach_retreat", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "demonstration_time");
  for (PhaseKind& phase : plan.approach.phase) phase = PhaseKind::grasp;
  EXPECT_EQ(of("approach_retreat", verify(plan)).size(), 2u);
}

TEST(VerifyPlan, JudgesTheRetreatToo) {
  Plan plan = planar::plan();
  plan.retreat = plan.trajectory;  // begins where the trajectory begins, not where it ends
  for (double& time_s : plan.retreat.demonstration_time) time_s = 2.8;
  for (PhaseKind& phase : plan.retreat.phase) phase = PhaseKind::rest;
  const auto found = verify(plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].plan, "reach/000/retreat");
  EXPECT_EQ(found[0].subject, "retreat");
}

TEST(VerifyPlan, APlanOfWhichEveryGoalIsOutOfReachIsNotExecutable) {
  Plan plan = planar::plan();
  for (std::uint8_t& reachable : plan.goals.reachable.values) reachable = 0;
  plan.tolerances.tracking_tolerance = plan.tolerances.tracking_tolerance_grasp =
      10;                                     // whatever it allows
  plan.tolerances.max_unreachable_share = 1;  // not even this: a config cannot say it
  const auto found = of("status", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "max_unreachable_share");
  EXPECT_EQ(found[0].value, 1);
  plan.approximate = true;
  EXPECT_TRUE(verify(plan).empty());
}

TEST(VerifyPlan, AShareOfGoalsOutOfReachIsCountedOverThoseThatWereSeen) {
  Plan plan = planar::plan();
  std::size_t seen = 0;
  for (std::size_t f = 0; f < plan.goals.frames(); ++f)
    seen += morphe::is_known(plan.goals.tip_position(f, 1));
  const std::size_t out = seen / 2 + 1;
  for (std::size_t f = 0; f < out; ++f) plan.goals.reachable(f, 1) = 0;
  const auto found = of("status", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].value, static_cast<double>(out) / static_cast<double>(seen));
  EXPECT_EQ(found[0].limit, 0.5);
  plan.tolerances.max_unreachable_share = 0.75;
  EXPECT_TRUE(verify(plan).empty());
}

TEST(VerifyPlan, ATipFartherThanThePlanAllowsMakesItApproximate) {
  Plan plan = planar::plan();
  plan.tolerances.max_tip_error = 0.9 * plan.certificate.tip_error_max;
  const auto found = of("status", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "max_tip_error");
  EXPECT_NEAR(found[0].value, plan.certificate.tip_error_max, 1e-9);
  plan.approximate = true;
  EXPECT_TRUE(verify(plan).empty());
}

TEST(VerifyPlan, MissingGoalsMakeAPlanApproximate) {
  const auto lengthen_gap = [](Plan& plan, std::size_t first, std::size_t last) {
    for (std::size_t f = first; f <= last; ++f)
      for (std::size_t tip = 0; tip < plan.goals.tip_position.cols; ++tip)
        plan.goals.tip_position(f, tip) = unknown_point();
  };
  Plan plan = planar::plan();
  plan.tolerances.max_goal_gap_s = 0.1;
  plan.tolerances.max_missing_goal_share = 1;
  const auto longest = [](const Plan& of) { return of.goals.time[40] - of.goals.time[20]; };
  lengthen_gap(plan, 21, 39);
  auto found = of("status", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "max_goal_gap_s");
  EXPECT_DOUBLE_EQ(found[0].value, longest(plan));
  EXPECT_EQ(found[0].unit, "s");
  plan.tolerances.max_goal_gap_s = 1;
  EXPECT_TRUE(of("status", verify(plan)).empty());
  plan.tolerances.max_missing_goal_share = 0.01;
  found = of("status", verify(plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].subject, "max_missing_goal_share");
  plan.approximate = true;
  EXPECT_TRUE(of("status", verify(plan)).empty());
}

TEST(VerifyPlan, AnInfeasiblePlanCertifiesNoTrajectory) {
  Plan plan = planar::plan();
  plan.reason = Reason::smoothing_collision;
  plan.trajectory = {};
  EXPECT_FALSE(of("certificate", verify(plan)).empty());
  plan.certificate = {};
  plan.grasp = {};
  EXPECT_TRUE(verify(plan).empty());
}

TEST(VerifyPlan, APlanThatReachesItsGoalsIsNotApproximate) {
  Plan plan = planar::plan();
  plan.approximate = true;
  ASSERT_EQ(of("status", verify(plan)).size(), 1u);
  plan.tolerances.max_unreachable_share = plan.tolerances.max_tip_error =
      kUnknown;  // an earlier file
  EXPECT_TRUE(of("status", verify(plan)).empty());
}

TEST(VerifyReport, IsWrittenAsTheDocumentsSay) {
  VerifyReport report{2, 3, 0, 1, {}, {}, {}, {true, false}};
  const std::string looked_at =
      ", \"looked_at\": {\"file\": true, \"curves\": true, \"inputs\": true, \"recordings\": "
      "false}}\n";
  EXPECT_EQ(verify_json(report),
            "{\"executable\": 2, \"approximate\": 3, \"partial\": 0, \"infeasible\": 1, "
            "\"violations\": [], \"assumptions\": []" +
                looked_at);
  report.violations = {{"a\"b/000", 7, 0.014, "jerk", "S1", 31.5, 31, "rad/s^3"},
                       {"a\"b/000", 8, 0.016, "tracking", "thumb", 0.012, 0.01, "m"},
                       {"c/001", -1, 0, "certificate", "duration_ratio", kUnknown, 1.25, ""}};
  EXPECT_EQ(
      verify_json(report),
      "{\"executable\": 2, \"approximate\": 3, \"partial\": 0, \"infeasible\": 1, \"violations\": "
      "[\n"
      "  {\"plan\": \"a\\\"b/000\", \"sample\": 7, \"time_s\": 0.014, \"cause\": \"jerk\", "
      "\"subject\": \"S1\", \"value\": 31.5, \"limit\": 31, \"unit\": \"rad/s^3\"},\n"
      "  {\"plan\": \"a\\\"b/000\", \"sample\": 8, \"time_s\": 0.016, \"cause\": \"tracking\", "
      "\"subject\": \"thumb\", \"value\": 0.012, \"limit\": 0.01, \"unit\": \"m\"},\n"
      "  {\"plan\": \"c/001\", \"sample\": -1, \"time_s\": 0, \"cause\": \"certificate\", "
      "\"subject\": \"duration_ratio\", \"value\": null, \"limit\": 1.25, \"unit\": \"\"}\n], "
      "\"assumptions\": []" +
          looked_at);
  EXPECT_THAT(verify_text(report),
              testing::HasSubstr("sample 7 (0.0140 s): jerk S1: 31.5 rad/s^3, limit 31 rad/s^3\n"));
  EXPECT_THAT(verify_text(report), testing::HasSubstr("tracking thumb: 12 mm, limit 10 mm\n"));
  EXPECT_THAT(verify_text(report),
              testing::EndsWith("2 executable, 3 approximate, 1 infeasible, 3 violations\n"));
  report.partial = 4;
  EXPECT_THAT(
      verify_text(report),
      testing::EndsWith("2 executable, 3 approximate, 4 partial, 1 infeasible, 3 violations\n"));
  report.approximate = report.partial = 0;
  EXPECT_THAT(verify_text(report),
              testing::EndsWith("\n2 executable, 1 infeasible, 3 violations\n"));
}

}  // namespace
}  // namespace morphe::verify
