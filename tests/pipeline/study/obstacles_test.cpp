#include "pipeline/study/obstacles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/study/colliding_states.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::study {
namespace {

constexpr double kLinkRadius_m = 0.02, kBallRadius_m = 0.02, kEnd_rad = 0.5;

/// The second link of a straight arm turns from 0 to 0.5 rad and enters a ball by 1 mm at the end.
struct TurnIntoABall {
  robot::Robot robot;
  Plan plan;
  Trajectory trajectory;

  static RobotModel arm() {
    RobotModel model = two_link_arm();
    model.capsules.push_back({"link", 1, Vec3::Zero(), Vec3(0.5, 0, 0), kLinkRadius_m, false});
    return model;
  }
  TurnIntoABall() : robot(arm()) {
    const Vec3 along(std::cos(kEnd_rad), std::sin(kEnd_rad), 0), across(-along.y(), along.x(), 0);
    SceneObject ball;
    ball.name = "ball";
    ball.shape = Shape::sphere;
    ball.size = {kBallRadius_m};
    ball.time = {0};
    ball.position = {0.9 * along + (kLinkRadius_m + kBallRadius_m - 0.001) * across};
    ball.orientation = {Quat::Identity()};
    plan.scene.objects = {ball};
    trajectory.time = trajectory.demonstration_time = {0, 1, 2};
    trajectory.position.resize(3, 2);
    trajectory.position << 0, 0, kEnd_rad / 2, 0, kEnd_rad, 0;
  }
};

TEST(CollidingStates, TheLastSampleIsAState) {
  TurnIntoABall turn;
  EXPECT_EQ(count_colliding_states(turn.robot, turn.plan, turn.trajectory, 0.01), 1);
  const JointRows reversed = turn.trajectory.position.colwise().reverse();
  turn.trajectory.position = reversed;
  EXPECT_EQ(count_colliding_states(turn.robot, turn.plan, turn.trajectory, 0.01), 1);
}

TEST(GraspRow, IsTheFirstRowOfTheGrasp) {
  Plan plan;
  plan.path.demonstration_time = {0, 0.1, 0.2, 0.3, 0.4};
  plan.path.position.setZero(5, 2);
  EXPECT_EQ(grasp_row(plan), 4) << "no grasp";
  plan.movement.phases = {{PhaseKind::reach, 0, 0.2}, {PhaseKind::grasp, 0.2, 0.4}};
  EXPECT_EQ(grasp_row(plan), 2);
  plan.movement.phases.back().begin_s = 0.5;
  EXPECT_EQ(grasp_row(plan), 4) << "after the path";
}

}  // namespace
}  // namespace morphe::study
