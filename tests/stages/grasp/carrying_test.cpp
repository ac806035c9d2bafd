#include "stages/grasp/carrying.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/robot/files/description.hpp"
#include "stages/grasp/measure.hpp"

namespace morphe::grasp {
namespace {

using testing::HasSubstr;

Movement drink() {
  Movement movement;
  movement.target = "cup";
  movement.end_s = 4;
  movement.phases = {{PhaseKind::reach, 0, 1},
                     {PhaseKind::grasp, 1, 1.5},
                     {PhaseKind::transport, 1.5, 3},
                     {PhaseKind::transport, 3.2, 4}};
  return movement;
}

/// Thumb and index on opposite sides of a cup of 30 mm radius, the middle finger beside the index.
Grasp three_pads() {
  Grasp grasp;
  grasp.quality.friction_coefficient = 0.8;
  for (const auto& [tip, x] :
       {std::pair{"thumb_tip", -0.03}, {"index_tip", 0.03}, {"middle_tip", 0.03}}) {
    PadContact contact;
    contact.tip = tip;
    contact.state = ContactState::touching;
    contact.point = Vec3(x, 0, grasp.contacts.size() == 2 ? 0.02 : 0);
    contact.normal = Vec3(x < 0 ? 1 : -1, 0, 0);
    contact.signed_distance = 0.0016;
    contact.pad_angle = 76 * kRadPerDegree;
    grasp.contacts.push_back(contact);
  }
  return grasp;
}

TEST(Carrying, BeginsWithTheFirstTransportThatIsPlanned) {
  Movement movement = drink();
  EXPECT_EQ(carrying_begin_s(movement), 1.5);
  movement.end_s = 1.5;
  EXPECT_TRUE(std::isnan(carrying_begin_s(movement))) << "the plan ends with the grasp";
  movement = drink();
  movement.target = "";
  EXPECT_TRUE(std::isnan(carrying_begin_s(movement)));
}

/// A plan with a movement and a grasp whose pads do not move in the hand.
Plan plan_of(const Movement& movement, const Grasp& grasp) {
  Plan plan;
  plan.movement = movement;
  plan.grasp = grasp;
  plan.certificate.held_drift = plan.certificate.held_turn = 0;
  return plan;
}

TEST(Carrying, NeedsTwoOpposedContactsThatTouch) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  Grasp grasp = three_pads();
  EXPECT_FALSE(check_held(robot, plan_of(drink(), grasp)));
  grasp.contacts[0].state = ContactState::near;
  const PlanningFailure lost = check_held(robot, plan_of(drink(), grasp));
  EXPECT_EQ(lost.reason, Reason::not_held);
  EXPECT_THAT(lost.detail, HasSubstr("cup is carried from 1.50 s on without two opposed contacts"));
  EXPECT_THAT(lost.detail, HasSubstr("thumb_tip is near it (gap 1.6 mm, pad 76 degrees off)"));
  EXPECT_THAT(lost.detail, HasSubstr("index_tip touches it"));
  Movement reach = drink();
  reach.end_s = 1.5;
  EXPECT_FALSE(check_held(robot, plan_of(reach, grasp))) << "nobody carries it";
  grasp.contacts.clear();
  EXPECT_THAT(check_held(robot, plan_of(drink(), grasp)).detail, HasSubstr("no pad touches it"));
}

TEST(Carrying, NeedsPadsThatKeepStillInTheHand) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  Plan plan = plan_of(drink(), three_pads());
  plan.certificate.held_drift = 0.0004;
  plan.certificate.held_turn = 0.9 * kRadPerDegree;
  EXPECT_FALSE(check_held(robot, plan));
  plan.certificate.held_drift = 0.0006;
  EXPECT_THAT(check_held(robot, plan).detail, HasSubstr("move by 0.60 mm"));
  plan.certificate.held_drift = 0;
  plan.certificate.held_turn = 1.1 * kRadPerDegree;
  EXPECT_EQ(check_held(robot, plan).reason, Reason::not_held);
  plan.certificate.held_turn = kUnknown;
  EXPECT_EQ(check_held(robot, plan).reason, Reason::not_held) << "unknown is not still";
}

TEST(Carrying, ThreeFingersHoldWithForceClosureThoughNoTwoAreOpposed) {
  Grasp grasp;
  grasp.quality.friction_coefficient = 0.3;  // the line between two is 30 degrees off, the cone 17
  for (const double angle : {0.0, 2 * M_PI / 3, 4 * M_PI / 3}) {
    PadContact contact;
    contact.state = ContactState::touching;
    contact.point = 0.03 * Vec3(std::cos(angle), std::sin(angle), 0);
    contact.normal = -contact.point.normalized();
    grasp.contacts.push_back(contact);
  }
  EXPECT_FALSE(is_held(grasp));
  grasp.quality.epsilon_lower = 0.02;
  EXPECT_TRUE(is_held(grasp));
}

TEST(Touching, IsASmallGapAndAPadThatFacesTheSurface) {
  const double straight = 0, side = 61 * kRadPerDegree;
  EXPECT_TRUE(is_touching(0.00019, straight));
  EXPECT_TRUE(is_touching(-0.0005, 59 * kRadPerDegree)) << "a pad may sink in";
  EXPECT_FALSE(is_touching(0.00021, straight));
  EXPECT_FALSE(is_touching(0, side));
  EXPECT_FALSE(is_touching(kUnknown, straight));
}

}  // namespace
}  // namespace morphe::grasp
