#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "planar_plan.hpp"
#include "stages/verify/finger_jacobian.hpp"
#include "stages/verify/grasp_config.hpp"
#include "stages/verify/held_drift.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

using Causes = std::set<std::string>;  ///< "cause subject"

/// What is said of the grasp alone: the phases are not those that the certificate was made for.
Causes found_in(const Plan& plan) {
  static const Causes of_the_grasp = {"grasp",       "contact",   "quality",
                                      "grasp_force", "structure", "finite"};
  Causes causes;
  for (const Violation& v : verify_plan(planar::robot(), "reach/000", plan)) {
    if (of_the_grasp.contains(v.cause)) causes.insert(v.cause + " " + v.subject);
  }
  return causes;
}

/// The planar reach, whose hand is widest open at its first sample and takes the cup, a sphere, at
/// its last: the index's pad is 2 mm inside, and nothing else is near.
Plan grasping() {
  Plan plan = planar::plan();
  plan.movement.phases = {{PhaseKind::reach, 2.0, 2.79, 1},
                          {PhaseKind::preshape, 2.5, 2.79, 1},
                          {PhaseKind::grasp, 2.7995, 2.8, 1}};
  const SceneObject& cup = plan.scene.objects[1];
  const Vec3 tip = planar::tip_at(planar::position_at(1)), centre = cup.position[0];
  plan.grasp = planar::grasp_at(plan, 100);
  plan.goals.tip_to_pad_share = {plan.goals.frames(), 2, 0.0};
  plan.goals.tip_to_pad_share(plan.goals.frames() - 1, 1) = 1;
  Grasp& grasp = plan.grasp;

  PadContact contact;
  contact.tip = "index";
  contact.link = "distal";
  contact.normal = (centre - tip).normalized();
  contact.point = contact.desired_point = contact.demonstrated_point = -0.03 * contact.normal;
  contact.state = ContactState::touching;
  contact.signed_distance = -0.002;
  contact.pad_angle = 0;
  grasp.contacts = {contact};
  // The pad's ball, of 10 mm, was to touch the cup of 30 mm.
  plan.goals.tip_position(plan.goals.frames() - 1, 1) = centre - 0.04 * contact.normal;
  GraspQuality& quality = grasp.quality;
  quality.friction_coefficient = 0.8;
  quality.torsional_friction = 0.002;
  quality.mass = 0.3;
  quality.centre_of_mass = Vec3::Zero();
  quality.characteristic_length = 0.03;
  return plan;
}

TEST(VerifyGrasp, AcceptsAnHonestGrasp) { EXPECT_EQ(found_in(grasping()), Causes()); }

TEST(VerifyGrasp, AFingerThatWasClosedMayHaveMetTheTargetBesideItsBall) {
  Plan plan = grasping();
  PadContact& contact = plan.grasp.contacts[0];
  contact.desired_point = Eigen::AngleAxisd(0.1, Vec3::UnitZ()) * contact.desired_point;
  plan.goals.auto_closed.assign(plan.goals.tip_position.cols, 0);
  plan.goals.auto_closed.back() = 1;
  contact.origin = ContactOrigin::auto_closed;
  const Vec3 touched = std::exchange(contact.demonstrated_point, unknown_point());
  EXPECT_EQ(found_in(plan), Causes());
  contact.demonstrated_point = touched;
  EXPECT_EQ(found_in(plan), Causes{"contact index/demonstrated_point"}) << "nobody touched there";
  contact.origin = ContactOrigin::demonstrated;
  plan.goals.auto_closed.clear();
  EXPECT_EQ(found_in(plan), Causes{"contact index/desired_point"});
}

TEST(VerifyGrasp, FindsWhatIsForged) {
  struct Case {
    const char* cause;
    std::function<void(Plan&)> forge;
  };
  const auto contact = [](Plan& plan) -> PadContact& { return plan.grasp.contacts[0]; };
  const auto turn = [&](Plan& plan, double by, const Vec3& axis) {
    contact(plan).normal = Eigen::AngleAxisd(by, axis) * contact(plan).normal;
  };
  const Case cases[] = {
      {"grasp sample", [](Plan& plan) { plan.grasp.sample = 99; }},
      {"grasp grasp_posture", [](Plan& plan) { plan.grasp.grasp_posture(1) += 1e-5; }},
      {"grasp pregrasp_posture", [](Plan& plan) { plan.grasp.pregrasp_posture(2) += 1e-5; }},
      {"grasp object_pose",
       [](Plan& plan) { plan.grasp.base_from_object.translation().x() += 1e-5; }},
      {"grasp palm_pose_in_object",
       [](Plan& plan) {
         plan.grasp.object_from_palm.rotate(Eigen::AngleAxisd(1e-4, Vec3::UnitY()));
       }},
      {"grasp tips_in_object", [](Plan& plan) { plan.grasp.tips_in_object[0].y() += 1e-5; }},
      {"grasp tips_in_object", [](Plan& plan) { plan.grasp.tips_in_object[1] = unknown_point(); }},
      {"contact index/state", [&](Plan& plan) { contact(plan).state = ContactState::near; }},
      {"contact index/demonstrated_point",
       [&](Plan& plan) { contact(plan).demonstrated_point *= 0.999; }},
      {"contact index/demonstrated_point",  // on the sphere, 20 mm away
       [&](Plan& plan) {
         contact(plan).demonstrated_point =
             Eigen::AngleAxisd(0.7, Vec3::UnitZ()) * contact(plan).desired_point;
       }},
      {"contact index/link", [&](Plan& plan) { contact(plan).link = "proximal"; }},
      {"contact pinkie/link", [&](Plan& plan) { contact(plan).tip = "pinkie"; }},
      {"contact index/point", [&](Plan& plan) { contact(plan).point *= 1.001; }},
      {"contact index/desired_point", [&](Plan& plan) { contact(plan).desired_point *= 0.999; }},
      {"contact index/desired_point",  // elsewhere on the sphere
       [&](Plan& plan) {
         contact(plan).desired_point =
             Eigen::AngleAxisd(0.1, Vec3::UnitZ()) * contact(plan).desired_point;
       }},
      {"contact index/missing", [](Plan& plan) { plan.grasp.contacts.clear(); }},
      {"contact index/missing", [&](Plan& plan) { plan.grasp.contacts.push_back(contact(plan)); }},
      {"contact index/missing", [](Plan& plan) { plan.goals.tip_to_pad_share = {}; }},
      {"contact index/origin",
       [&](Plan& plan) { contact(plan).origin = ContactOrigin::auto_closed; }},
      {"contact index/signed_distance", [&](Plan& plan) { contact(plan).signed_distance += 2e-5; }},
      {"contact index/normal", [&](Plan& plan) { contact(plan).normal *= -1; }},
      {"contact index/normal", [&](Plan& plan) { contact(plan).normal *= 1.01; }},
      {"contact index/normal", [&](Plan& plan) { turn(plan, 0.01, Vec3::UnitZ()); }},
      {"contact index/pad",
       [&](Plan& plan) {  // another point of the sphere, with the normal that is its own
         turn(plan, 0.01, Vec3::UnitZ());
         contact(plan).point = -0.03 * contact(plan).normal;
       }},
      {"contact index/pad_angle", [&](Plan& plan) { contact(plan).pad_angle = 1e-4; }},
      {"contact index/confidence", [&](Plan& plan) { contact(plan).confidence = kUnknown; }},
      {"contact index/penetration", [](Plan& plan) { plan.tolerances.max_penetration = 0.0019; }},
      {"finite grasp/contacts/index",
       [&](Plan& plan) { contact(plan).signed_distance = kUnknown; }},
      {"quality friction_coefficient",
       [](Plan& plan) { plan.grasp.quality.friction_coefficient = -0.1; }},
      {"quality centre_of_mass", [](Plan& plan) { plan.grasp.quality.centre_of_mass.z() = 1e-3; }},
      {"quality characteristic_length",
       [](Plan& plan) { plan.grasp.quality.characteristic_length = 0.04; }},
      {"quality epsilon_lower", [](Plan& plan) { plan.grasp.quality.epsilon_lower = 0.1; }},
      {"quality available_force", [](Plan& plan) { plan.grasp.quality.available_force = 10; }},
      {"grasp_force index/normal_force", [&](Plan& plan) { contact(plan).normal_force = 1; }},
      {"grasp_force torque",
       [](Plan& plan) {
         plan.grasp.grasp_torque = plan.grasp.servo_target = JointVector::Zero(3);
       }},
      {"structure grasp/grasp_force",
       [](Plan& plan) {
         plan.grasp.contacts.clear();
         plan.grasp.grasp_torque = plan.grasp.servo_target = JointVector::Zero(3);
       }},
  };
  for (const Case& c : cases) {
    Plan plan = grasping();
    c.forge(plan);
    EXPECT_EQ(found_in(plan).count(c.cause), 1u) << c.cause;
  }
}

TEST(VerifyGrasp, ATargetThatIsCarriedIsHeldByTwoOpposedContacts) {
  Plan plan = grasping();
  plan.movement.phases.push_back({PhaseKind::transport, 2.7999, 2.8, 1});
  EXPECT_EQ(found_in(plan).count("contact opposed"), 0u) << "without the section grasp";
  plan.tolerances.max_link_penetration = 0.005;
  EXPECT_EQ(found_in(plan).count("contact opposed"), 1u);
  PadContact opposite = plan.grasp.contacts[0];
  opposite.tip = "thumb";
  opposite.point *= -1;
  opposite.normal *= -1;
  plan.grasp.contacts.push_back(opposite);
  EXPECT_EQ(found_in(plan).count("contact opposed"), 0u);
  plan.grasp.contacts[1].state = ContactState::near;
  EXPECT_EQ(found_in(plan).count("contact opposed"), 1u) << "which is only near";
}

TEST(VerifyGrasp, FingersThatMoveWhileTheyCarryAreMeasuredInThePalm) {
  Plan plan = grasping();
  plan.movement.phases.push_back({PhaseKind::transport, 2.5, 2.8, 1});
  plan.grasp.sample = 50;
  Certificate own;
  recompute_held_drift(planar::robot(), plan, own);
  // The palm is the upper arm: the distal link turns by the elbow's angle and twice the finger's.
  const auto end_of = [](const Eigen::Vector3d& q) {
    const double finger = q[1] + q[2], distal = q[1] + 2 * q[2] + 0.1;
    return Eigen::Vector2d(
        0.25 * std::cos(q[1]) + 0.08 * std::cos(finger) + 0.06 * std::cos(distal),
        0.25 * std::sin(q[1]) + 0.08 * std::sin(finger) + 0.06 * std::sin(distal));
  };
  const Eigen::Vector3d before = planar::position_at(0.5), after = planar::position_at(1);
  EXPECT_NEAR(own.held_turn, (after[1] - before[1]) + 2 * (after[2] - before[2]), 1e-9);
  EXPECT_NEAR(own.held_drift, (end_of(after) - end_of(before)).norm(), 1e-9);
  plan.movement.end_s = 2.5;
  Certificate carries_nothing;
  recompute_held_drift(planar::robot(), plan, carries_nothing);
  EXPECT_TRUE(std::isnan(carries_nothing.held_drift));
}

TEST(VerifyGrasp, JudgesTheGoalsOfPads) {
  const auto with = [](double share, std::uint8_t closed) {
    Plan plan = planar::plan();
    plan.goals.tip_to_pad_share = Array2D<double>(plan.goals.frames(), 2, 0);
    plan.goals.tip_to_pad_share(3, 0) = share;
    plan.goals.auto_closed = {0, closed};
    return found_in(plan);
  };
  EXPECT_EQ(with(1, 1), Causes());
  for (const double share : {-0.1, 1.01, kUnknown}) {
    EXPECT_EQ(with(share, 0), Causes{"structure goals/tip_to_pad_share"});
  }
  EXPECT_EQ(with(0, 2), Causes{"structure goals/auto_closed"});
}

TEST(VerifyGrasp, LeversAreThoseOfTheFingersAlone) {
  // The palm is the shoulder's frame; a planar joint moves a point at right angles to the way
  // there.
  const RobotModel robot = planar::robot();
  const Eigen::Vector3d q = planar::position_at(0.4);
  const Vec3 tip = planar::tip_at(q);
  const Eigen::Matrix3Xd levers = finger_jacobian(robot, q, 3, tip);
  EXPECT_TRUE(levers.col(0).isZero(0));
  const Vec3 elbow(0.3 * std::cos(q(0)), 0.3 * std::sin(q(0)), 0.1);
  EXPECT_LT((levers.col(1) - Vec3::UnitZ().cross(tip - elbow)).norm(), 1e-9);
}

TEST(VerifyGrasp, ReadsNumbersOfTheSectionGraspAlone) {
  const std::string config =
      "check:\n  friction_coefficient: 2\ngrasp:\n  close_fingers: true\n  friction_coefficient: "
      "0.8\n  mass: 1e-05\n"
      "  deeper:\n    torsional_friction: 3\nrepair:\n  torsional_friction: 4\n";
  EXPECT_EQ(grasp_config_value(config, "friction_coefficient"), 0.8);
  EXPECT_EQ(grasp_config_value(config, "mass"), 1e-5);
  EXPECT_EQ(grasp_config_value(config, "torsional_friction"), std::nullopt);
  EXPECT_EQ(grasp_config_value(config, "close_fingers"), std::nullopt);
  EXPECT_EQ(grasp_config_value("", "friction_coefficient"), std::nullopt);
}

}  // namespace
}  // namespace morphe::verify
