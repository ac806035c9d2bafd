#include "stages/map/path_problem.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/humanlike/arm_chain.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/map_options.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// Six frames in which the human wrist moves along a line and nothing else has a goal.
struct WristOnly {
  explicit WristOnly(double wrist_motion)
      : robot(robot::shipped_robot("pa10_dlr_hit2")),
        world(collision::make_world(robot, scene, Movement{}, Tolerances{})) {
    problem.robot = &robot;
    problem.world = &world;
    problem.clearance.weight = 0;
    problem.wrist_motion = wrist_motion;
    for (int f = 0; f < 6; ++f) {
      humanlike::FrameGoal goal;
      goal.tip_position.assign(robot.tips.size(), unknown_point());
      goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
      goal.wrist = Vec3(0.01 * f, 0.02 * f * f, 0.3);
      problem.goals.push_back(goal);
      problem.time.push_back(0.01 * f);
    }
  }
  WristOnly(const WristOnly&) = delete;

  /// Returns the position of the robot's wrist along a path.
  std::vector<Vec3> wrists(const JointRows& path) const {
    std::vector<Vec3> found;
    std::vector<Pose> poses;
    for (Index f = 0; f < path.rows(); ++f) {
      robot::forward_kinematics(robot, path.row(f).transpose(), poses);
      found.push_back(humanlike::arm_wrist(robot, poses).position);
    }
    return found;
  }

  JointRows constant_path(const JointVector& q) const {
    return q.transpose().replicate(static_cast<Index>(problem.frames()), 1);
  }

  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
};

JointVector bent_posture(const robot::Robot& robot) {
  JointVector q = JointVector::Zero(robot.lower.size());
  q.head(7) << 0.3, 0.6, -0.2, 1.2, 0.4, 0.5, 0.1;
  return q;
}

/// The derivatives with respect to joints and offset against differences of the value.
TEST(WristMotion, Gradient) {
  const WristOnly bench(2);
  const PathProblem path(bench.problem, MovementCost{});
  ASSERT_TRUE(path.has_offsets);
  std::mt19937_64 random(3);
  for (int k = 0; k < 5; ++k) {
    JointVector variables(bench.robot.lower.size() + 3);
    variables << random_position(bench.robot, random), 0.1, -0.2, 0.3;
    solve::Quadratic model;
    const auto value = [&](const JointVector& at) {
      model.reset(at.size());
      path.movement.frame_model(2, at, model);
      return model.value;
    };
    value(variables);
    const JointVector gradient = model.gradient;
    constexpr double kStep = 1e-6;  // [rad] or [m]
    for (Index j = 0; j < variables.size(); ++j) {
      JointVector ahead = variables, behind = variables;
      ahead[j] += kStep;
      behind[j] -= kStep;
      EXPECT_NEAR(gradient[j], (value(ahead) - value(behind)) / (2 * kStep), 1e-5);
    }
  }
}

/// Without other goals the wrist moves as the person's, wherever it is.
TEST(WristMotion, TheWristMovesAsThePersons) {
  const WristOnly bench(1);
  const JointRows start = bench.constant_path(bent_posture(bench.robot));
  solve::MovementOptions options;
  options.relative_tolerance = 1e-12;
  options.max_iterations = 500;
  const JointRows path = minimise_path(bench.problem, start, {1e-9, 0, 0}, options).q;
  ASSERT_EQ(path.cols(), bench.robot.lower.size());
  const std::vector<Vec3> wrists = bench.wrists(path);
  for (std::size_t f = 1; f < wrists.size(); ++f) {
    const Vec3 of_robot = wrists[f] - wrists[f - 1];
    const Vec3 of_person = bench.problem.goals[f].wrist - bench.problem.goals[f - 1].wrist;
    EXPECT_LT((of_robot - of_person).norm(), 1e-4);
  }
}

/// A person who stands elsewhere makes no difference: the offset takes it up.
TEST(WristMotion, APersonElsewhereMakesNoDifference) {
  WristOnly bench(1);
  const JointRows start = bench.constant_path(bent_posture(bench.robot));
  const JointRows here = minimise_path(bench.problem, start, MovementCost{}, {}).q;
  for (humanlike::FrameGoal& goal : bench.problem.goals) goal.wrist += Vec3(0.5, -1, 2);
  const JointRows there = minimise_path(bench.problem, start, MovementCost{}, {}).q;
  EXPECT_LT((here - there).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_GT((here - start).cwiseAbs().maxCoeff(), 0.01);
}

TEST(WristMotion, ThereIsNoOffsetWithoutItsWeightOrTheWrist) {
  const WristOnly without_weight(0);
  EXPECT_FALSE(PathProblem(without_weight.problem, MovementCost{}).has_offsets);
  WristOnly without_wrist(1);
  for (humanlike::FrameGoal& goal : without_wrist.problem.goals) goal.wrist = unknown_point();
  const PathProblem path(without_wrist.problem, MovementCost{});
  EXPECT_FALSE(path.has_offsets);
  EXPECT_EQ(path.movement.lower.size(), without_wrist.robot.lower.size());
}

TEST(WristOffsets, AreThoseOfTheFramesThatWereSeen) {
  WristOnly bench(1);
  const JointRows path = bench.constant_path(bent_posture(bench.robot));
  const Vec3 wrist = bench.wrists(path).front();
  for (humanlike::FrameGoal& goal : bench.problem.goals) goal.wrist = unknown_point();
  bench.problem.goals[1].wrist = Vec3(1, 0, 0);
  bench.problem.goals[3].wrist = Vec3(0, 1, 0);
  const JointRows offsets = wrist_offsets(bench.problem, path);
  for (const Index f : {0, 1, 2})
    EXPECT_LT((offsets.row(f).transpose() - (wrist - Vec3(1, 0, 0))).norm(), 1e-12);
  for (const Index f : {3, 4, 5})
    EXPECT_LT((offsets.row(f).transpose() - (wrist - Vec3(0, 1, 0))).norm(), 1e-12);
}

}  // namespace
}  // namespace morphe::map
