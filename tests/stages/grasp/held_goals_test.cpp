#include "stages/grasp/held_goals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/held_drift.hpp"

namespace morphe::grasp {
namespace {

const robot::Robot& reference_robot() {
  static const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  return robot;
}

/// A cup that is grasped at 1 s, turns about its axis by 1 rad/s and rises by 0.1 m/s from 1.5 s to
/// 2.5 s, and rests from then on. Thumb and index were seen, the middle finger until 1.2 s.
struct TurnedCup {
  SceneObject cup;
  Movement movement;
  Goals goals;

  TurnedCup() {
    cup.name = movement.target = "cup";
    cup.shape = Shape::cylinder;
    cup.size = {0.03, 0.1};
    movement.end_s = 3.5;
    movement.phases = {{PhaseKind::reach, 0, 1},    {PhaseKind::preshape, 0.4, 1},
                       {PhaseKind::grasp, 1, 1.5},  {PhaseKind::transport, 1.5, 2.5},
                       {PhaseKind::hold, 2.5, 2.6}, {PhaseKind::return_phase, 2.6, 3.5}};
    const std::size_t frames = 351;
    goals.tip_position = {frames, 5, unknown_point()};
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = 0.01 * static_cast<double>(f), carried_s = std::clamp(t - 1.5, 0.0, 1.0);
      goals.time.push_back(t);
      goals.tip_position(f, 0) = Vec3(0.4, 0.1, 0.2);
      goals.tip_position(f, 1) = Vec3(0.5, 0.1, 0.2);
      if (t < 1.2) goals.tip_position(f, 2) = Vec3(0.5, 0.12, 0.2);
      cup.time.push_back(t);
      cup.position.push_back(Vec3(0.45, 0.1, 0.2 + 0.1 * carried_s));
      cup.orientation.push_back(Quat(Eigen::AngleAxisd(carried_s, Vec3::UnitZ())));
    }
  }
};

TEST(HeldGoals, TurnWithTheTargetAsOneBody) {
  TurnedCup held;
  const robot::Robot& robot = reference_robot();
  const JointVector q = 0.5 * (robot.lower + robot.upper);
  const Goals before = held.goals;
  set_held_goals(robot, {}, q, 100, held.movement, held.cup, held.goals);
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, q, base_from_frame);
  for (std::size_t tip = 0; tip < 5; ++tip) {
    const Vec3 at_grasp = robot::tip_pose(robot, base_from_frame, tip).translation();
    EXPECT_LT((held.goals.tip_position(120, tip) - at_grasp).norm(), 1e-12);
    // Half way the cup has turned by 0.5 rad about (0.45, 0.1) and risen by 50 mm.
    const Vec3 from_axis = at_grasp - Vec3(0.45, 0.1, 0);
    const Vec3 turned = Vec3(0.45, 0.1, 0.05) + Eigen::AngleAxisd(0.5, Vec3::UnitZ()) * from_axis;
    EXPECT_LT((held.goals.tip_position(200, tip) - turned).norm(), 1e-12) << tip;
  }
  EXPECT_EQ(held.goals.tip_position(30, 0), before.tip_position(30, 0)) << "before the preshape";
  EXPECT_EQ(held.goals.tip_position(320, 0), before.tip_position(320, 0)) << "after the release";
  EXPECT_EQ(held.goals.auto_closed, (std::vector<std::uint8_t>{0, 0, 0, 1, 1}))
      << "the middle finger was seen in the grasp";
  EXPECT_FALSE(is_known(held.goals.tip_position(90, 4)));
  EXPECT_FALSE(is_known(held.goals.tip_position(262, 4))) << "let go";
}

TEST(HeldGoals, BeginAndEndWithTimeToSettle) {
  const HoldInterval hold = hold_interval(TurnedCup().movement);
  EXPECT_EQ(hold.begin_s, 1);
  EXPECT_EQ(hold.release_s, 2.5);
  EXPECT_FALSE(is_held_at(hold, 0.95));
  EXPECT_TRUE(is_held_at(hold, 0.97));
  EXPECT_TRUE(is_held_at(hold, 2.53));
  EXPECT_FALSE(is_held_at(hold, 2.55));
  EXPECT_EQ(closing_progress(hold, 0.97), 1);
  EXPECT_LT(closing_progress(hold, 2.6), 1);
}

TEST(HeldGoals, CloseInTimeThoughTheHandOpensJustBeforeTheGrasp) {
  Movement movement = TurnedCup().movement;
  movement.phases[1].begin_s = 0.98;  // the preshape is shorter than the hand takes to settle
  const HoldInterval hold = hold_interval(movement);
  EXPECT_EQ(closing_progress(hold, 0.5), 0);
  EXPECT_GT(closing_progress(hold, 0.9), 0);
  EXPECT_EQ(closing_progress(hold, 0.97), 1);
  EXPECT_EQ(closing_progress(hold, 2), 1);
}

/// A plan that carries the cup with a touching index finger, and turns its outer joint by `turn`.
Plan plan_with_turned_index(double turn, double at_s) {
  const robot::Robot& robot = reference_robot();
  Plan plan;
  plan.movement = TurnedCup().movement;
  plan.grasp.sample = 10;
  PadContact contact;
  contact.tip = robot.tips[1].name;
  contact.state = ContactState::touching;
  plan.grasp.contacts = {contact};
  const JointVector q = 0.5 * (robot.lower + robot.upper);
  int joint = -1;  // the outermost one that moves the tip
  for (int frame = robot.tips[1].frame; joint < 0; frame = robot.frames[frame].parent)
    joint = robot.frames[frame].joint;
  Trajectory& motion = plan.trajectory;
  motion.position = JointRows(36, q.size());
  for (int i = 0; i < 36; ++i) {
    motion.time.push_back(0.1 * i);
    motion.demonstration_time.push_back(0.1 * i);
    motion.position.row(i) = q.transpose();
    motion.position(i, robot.arm_joints[0]) += 0.01 * i;
    if (std::abs(0.1 * i - at_s) < 0.01) motion.position(i, joint) += turn;
  }
  return plan;
}

TEST(HeldDrift, IsTheMotionOfAPadInThePalm) {
  const HeldDrift still = held_drift(reference_robot(), plan_with_turned_index(0, 0));
  EXPECT_LT(still.displacement_m, 1e-12) << "the arm moves, the fingers do not";
  EXPECT_LT(still.turn_rad, 1e-12);
  const HeldDrift moved = held_drift(reference_robot(), plan_with_turned_index(0.02, 2));
  EXPECT_GE(moved.turn_rad, 0.02 - 1e-12) << "coupled joints turn it further";
  EXPECT_GT(moved.displacement_m, 0.02 * 0.015);
  EXPECT_LT(moved.displacement_m, 0.02 * 0.08) << "no farther than the finger is long";
  const HeldDrift released = held_drift(reference_robot(), plan_with_turned_index(0.02, 3));
  EXPECT_LT(released.displacement_m, 1e-12) << "after the release it may open";
  Plan reach = plan_with_turned_index(0.02, 2);
  reach.movement.end_s = 1.5;
  EXPECT_TRUE(std::isnan(held_drift(reference_robot(), reach).displacement_m));
  Plan near = plan_with_turned_index(0.02, 2);
  near.grasp.contacts[0].state = ContactState::near;
  EXPECT_TRUE(std::isnan(held_drift(reference_robot(), near).turn_rad));
}

}  // namespace
}  // namespace morphe::grasp
