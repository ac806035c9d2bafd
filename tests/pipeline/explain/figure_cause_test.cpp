#include "pipeline/explain/figure_cause.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/explain/posture.hpp"

namespace morphe::explain {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kHumanUpperArm_m = 0.28, kHumanForearm_m = 0.25;
constexpr int kFrames = 40;

/// A robot of two links in the plane z = 0, with a palm and two tips at their end.
robot::Robot planar_robot(double size) {
  RobotModel robot;
  robot.joint_names = {"shoulder", "elbow", "wrist"};
  robot.lower = JointVector::Constant(3, -4);
  robot.upper = robot.velocity = robot.acceleration = robot.jerk = JointVector::Constant(3, 4);
  const auto at = [](double x) { return Pose(Eigen::Translation3d(x, 0, 0)); };
  robot.frames = {{"upper_arm", -1, at(0), Vec3::UnitZ(), 0, 1, 0},
                  {"forearm", 0, at(size * kHumanUpperArm_m), Vec3::UnitZ(), 1, 1, 0},
                  {"palm", 1, at(size * kHumanForearm_m), Vec3::UnitZ(), 2, 1, 0}};
  robot.joint_centres = {{1, "arm"}, {2, "arm"}};
  robot.palm_frame = 2;
  robot.tips.resize(2);
  for (int tip = 0; tip < 2; ++tip) {
    robot.tips[tip].name = tip == 0 ? "thumb" : "index";
    robot.tips[tip].frame = 2;
    robot.tips[tip].finger = tip;
    robot.tips[tip].transform = Pose(Eigen::Translation3d(0.12, tip == 0 ? 0.03 : -0.03, 0));
  }
  return robot::Robot(std::move(robot));
}

Vec3 unit_at(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

Quat turned(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

/// The changes that were made to a robot that follows the person exactly.
struct Construct {
  double size = 1;                  ///< of the links, over the person's
  Vec3 base_shift = Vec3::Zero();   ///< of the base from the person's shoulder [m]
  Vec3 larger_hand = Vec3::Zero();  ///< the wrist's distance from its place, in the hand [m]
  double palm_turn = 0;             ///< of the palm about the middle of the tips [rad]
  Vec3 tips_off = Vec3::Zero();     ///< the tips' distance from their goals [m]
};

/// Returns joint angles with the wrist at a point, the elbow bent to the left and the palm turned.
Eigen::Vector3d posture_at(double size, const Vec3& wrist, double palm) {
  const double a = size * kHumanUpperArm_m, b = size * kHumanForearm_m;
  const double elbow = std::acos((wrist.squaredNorm() - a * a - b * b) / (2 * a * b));
  const double shoulder =
      std::atan2(wrist.y(), wrist.x()) - std::atan2(b * std::sin(elbow), a + b * std::cos(elbow));
  return {shoulder, elbow, palm - shoulder - elbow};
}

/// A person who reaches, and a trajectory whose wrist is where the construct puts it.
Plan plan_of(const robot::Robot& robot, const Construct& construct) {
  Plan plan;
  plan.reason = Reason::none;
  plan.trajectory.position.resize(kFrames, 3);
  plan.goals.tip_position = Array2D<Vec3>(kFrames, robot.tips.size(), unknown_point());
  const Vec3 from_tips(-0.12, 0, 0);  // to the wrist, in the hand
  for (int k = 0; k < kFrames; ++k) {
    const double share = static_cast<double>(k) / (kFrames - 1), hand = 0.4 + 2 * share;
    const Vec3 shoulder = -construct.base_shift;
    const Vec3 elbow = shoulder + kHumanUpperArm_m * unit_at(-1 + 0.9 * share);
    const Vec3 wrist = elbow + kHumanForearm_m * unit_at(0.9 + 0.7 * share * share);
    const double palm = hand + construct.palm_turn;
    const Vec3 tips = wrist - turned(hand) * from_tips;
    const Vec3 driven_wrist =
        tips + construct.tips_off + turned(palm) * (from_tips + construct.larger_hand);
    plan.goals.time.push_back(share);
    plan.goals.shoulder_position.push_back(shoulder);
    plan.goals.elbow_position.push_back(elbow);
    plan.goals.wrist_position.push_back(wrist);
    plan.goals.wrist_orientation.push_back(turned(hand));
    plan.trajectory.position.row(k) = posture_at(construct.size, driven_wrist, palm);
    std::vector<Pose> frames;
    robot::forward_kinematics(robot, plan.trajectory.position.row(k).transpose(), frames);
    Vec3 middle = Vec3::Zero();
    for (int tip = 0; tip < 2; ++tip)
      middle += robot::tip_pose(robot, frames, tip).translation() / 2;
    // The robot's fingers are what they must be for its tips to be at the goals.
    for (int tip = 0; tip < 2; ++tip)
      plan.goals.tip_position(k, tip) =
          robot::tip_pose(robot, frames, tip).translation() - middle + tips;
  }
  plan.trajectory.time = plan.trajectory.demonstration_time = plan.goals.time;
  return plan;
}

FigureCauses causes_of(const Construct& construct) {
  robot::Robot robot = planar_robot(construct.size);
  for (RobotModel::Tip& tip : robot.tips) tip.transform.translation() -= construct.larger_hand;
  const Plan plan = plan_of(robot, construct);
  constexpr double kDriven = 0.4;  // forced by the wrist, as two joints cannot turn the elbow
  return causes_of_direction(kDriven, kDriven, wrist_offset(robot, plan));
}

TEST(FigureCause, AMovedBaseIsThePlacement) {
  for (const Vec3& shift : {Vec3(0.1, 0, 0), Vec3(-0.06, 0.08, 0), Vec3(0, -0.1, 0)}) {
    const FigureCauses causes = causes_of({.base_shift = shift});
    EXPECT_THAT(causes.all, ElementsAre(FigureCause::placement));
    EXPECT_THAT(causes.instead, IsEmpty());
  }
}

TEST(FigureCause, LinksOfAnotherLengthAreTheSizeWhereverTheBaseIs) {
  const FigureCauses causes = causes_of({.size = 1.6});
  EXPECT_THAT(causes.all, ElementsAre(FigureCause::size));
  EXPECT_THAT(causes.instead, IsEmpty());
  const robot::Robot robot = planar_robot(1.6);
  const WristOffset offset = wrist_offset(robot, plan_of(robot, {.size = 1.6}));
  const FigureCauses placed = causes_of({.size = 1.6, .base_shift = offset.base_shift});
  EXPECT_THAT(placed.all, ElementsAre(FigureCause::size)) << "no base is better than this one";
}

TEST(FigureCause, ALargerHandIsTheHand) {
  const FigureCauses causes = causes_of({.larger_hand = Vec3(-0.08, 0, 0)});
  EXPECT_THAT(causes.all, ElementsAre(FigureCause::robot_hand));
  EXPECT_THAT(causes.instead, IsEmpty());
}

TEST(FigureCause, ATurnedPalmIsThePalmsAngle) {
  const FigureCauses causes = causes_of({.palm_turn = 0.8});
  EXPECT_THAT(causes.all, ElementsAre(FigureCause::palm_angle));
  EXPECT_THAT(causes.instead, IsEmpty());
}

TEST(FigureCause, TipsOffTheirGoalsAreNotToldApartFromABaseThatWouldFollowThem) {
  const FigureCauses causes = causes_of({.tips_off = Vec3(0, 0.09, 0)});
  EXPECT_THAT(causes.all, ElementsAre(FigureCause::tips));
  EXPECT_THAT(causes.instead, ElementsAre(FigureCause::placement));
}

TEST(FigureCause, TwoThingsThatOneChangeDoesNotMendAreNamedTogether) {
  const FigureCauses causes = causes_of({.base_shift = Vec3(0.1, 0, 0), .palm_turn = 1.2});
  EXPECT_THAT(causes.all, ElementsAre(FigureCause::palm_angle, FigureCause::placement));
}

TEST(FigureCause, OfThePalmIsTheLargestPartAndWhatIsCloseToIt) {
  const auto causes = [](double hand, double robot, double driven) {
    return causes_of_palm(driven * kRadPerDegree,
                          {driven * kRadPerDegree, robot * kRadPerDegree, hand * kRadPerDegree});
  };
  EXPECT_THAT(causes(32, 32, 46).all, ElementsAre(FigureCause::robot_hand));
  EXPECT_THAT(causes(32, 32, 46).instead, IsEmpty());
  EXPECT_THAT(causes(22, 22, 42).all, ElementsAre(FigureCause::robot_hand));
  EXPECT_THAT(causes(22, 22, 42).instead, ElementsAre(FigureCause::weights_or_solver));
  EXPECT_THAT(causes(5, 40, 45).all, ElementsAre(FigureCause::placement_or_size));
  EXPECT_THAT(causes(2, 3, 5).all, ElementsAre(FigureCause::small));
}

TEST(FigureCause, WithoutGoalsForTheHandTheWristIsNotTakenApart) {
  const robot::Robot robot = planar_robot(1);
  Plan plan = plan_of(robot, {.palm_turn = 0.8});
  plan.goals.wrist_orientation.clear();
  EXPECT_THAT(causes_of_direction(0.4, 0.4, wrist_offset(robot, plan)).all,
              ElementsAre(FigureCause::wrist_place));
}

TEST(WristOffset, PartsOfTheDistanceFromThePersonsWristAddUp) {
  const robot::Robot robot = planar_robot(1.2);
  const Construct construct{.size = 1.2, .base_shift = Vec3(0.05, 0, 0), .palm_turn = 0.5};
  const WristOffset found = wrist_offset(robot, plan_of(robot, construct));
  EXPECT_NEAR(found.from_human, 2 * 0.12 * std::sin(0.25), 1e-9);
  EXPECT_NEAR(found.palm, found.from_human, 1e-9);
  EXPECT_NEAR(found.fingers, 0, 1e-9);
  EXPECT_NEAR(found.tips, 0, 1e-9);
  EXPECT_NEAR(found.after[kLinksChange | kFingersChange | kPalmChange], 0.05, 1e-9);
  EXPECT_NEAR(found.upper_arm, 1.2 * kHumanUpperArm_m, 1e-9);
  EXPECT_NEAR(found.human_forearm, kHumanForearm_m, 1e-9);
}

}  // namespace
}  // namespace morphe::explain
