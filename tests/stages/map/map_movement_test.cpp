#include "stages/map/map_movement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/re_solve_path.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// Goals made by moving the reference robot itself along a smooth joint path: reachable without any
/// error, so that the mapping has to find a continuous way that meets all of them.
class MapMovement : public testing::Test {
 protected:
  MapMovement()
      : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {
    constexpr int kFrames = 40;
    JointVector from = JointVector::Zero(static_cast<Index>(robot.joints()));
    from.head(7) << 1.2, -1.0, -1.6, 1.6, 2.5, 0.7, 0.5;
    from.tail(15) << 0.1, 0.5, 0.4, 0, 0.3, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3;
    JointVector by = JointVector::Zero(from.size());
    by.head(7) << 0.25, 0.1, -0.2, -0.3, 0.2, 0.1, 0.3;
    by.tail(15).setConstant(0.1);
    goals.tip_position = {kFrames, robot.tips.size(), unknown_point()};
    goals.tip_orientation = {kFrames, robot.tips.size(), unknown_rotation()};
    goals.reachable = {kFrames, robot.tips.size(), 0};
    goals.finger_joint_position = {kFrames, kFingerCount, unknown_point()};
    std::vector<Pose> poses;
    for (int f = 0; f < kFrames; ++f) {
      const double s = f / (kFrames - 1.0);
      const JointVector q = from + (10 - 15 * s + 6 * s * s) * s * s * s * by;
      robot::forward_kinematics(robot, q, poses);
      goals.time.push_back(0.01 * f);
      for (const std::size_t tip : {0U, 1U}) {
        goals.tip_position(static_cast<std::size_t>(f), tip) =
            robot::tip_pose(robot, poses, tip).translation();
      }
      goals.shoulder_position.push_back(
          poses[static_cast<std::size_t>(robot.shoulder_frame)].translation());
      goals.elbow_position.push_back(
          poses[static_cast<std::size_t>(robot.joint_centres[0].frame)].translation());
      goals.wrist_position.push_back(
          poses[static_cast<std::size_t>(robot.joint_centres[1].frame)].translation());
      goals.wrist_orientation.emplace_back(
          poses[static_cast<std::size_t>(robot.palm_frame)].linear());
    }
    world = collision::make_world(robot, scene, Movement{}, Tolerances{});
    options.starts = 16;
    options.candidates = 3;
  }

  Outcome<MapResult> solve(std::uint64_t seed = 5) {
    return map_movement(make_mapping_problem(robot, goals, world, options), goals, options, seed);
  }

  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  Goals goals;
  MapOptions options;
};

TEST_F(MapMovement, MeetsReachableGoalsInsideTheLimitsWithoutAJump) {
  const auto [result, refusal] = solve();
  ASSERT_FALSE(refusal) << refusal.detail;
  for (Index f = 0; f < result.mapped.position.rows(); ++f) {
    for (const Index tip : {0, 1}) EXPECT_LT(result.mapped.tip_error(f, tip), 1e-3);
    EXPECT_TRUE(std::isnan(result.mapped.tip_error(f, 2)));
    EXPECT_EQ(result.mapped.status[static_cast<std::size_t>(f)], FrameStatus::met);
    EXPECT_TRUE(goals.reachable(static_cast<std::size_t>(f), 0));
    const JointVector q = result.mapped.position.row(f).transpose();
    EXPECT_TRUE((q.array() >= robot.lower.array()).all());
    EXPECT_TRUE((q.array() <= robot.upper.array()).all());
    if (f > 0) {
      const auto step = result.mapped.position.row(f) - result.mapped.position.row(f - 1);
      EXPECT_LT(step.cwiseAbs().maxCoeff(), 0.06);
    }
  }
}

TEST_F(MapMovement, StaysOffAnObstacleThatItKnows) {
  const MapResult free = solve().value;
  // A ball where the elbow's capsules are, half way: the arm has to swing aside.
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, free.mapped.position.row(20).transpose(), poses);
  SceneObject ball;
  ball.name = "ball";
  ball.shape = Shape::sphere;
  ball.size = {0.03};
  ball.time = {0};
  ball.position = {poses[static_cast<std::size_t>(robot.joint_centres[0].frame)].translation() +
                   Vec3(0.09, 0, 0)};
  ball.orientation = {Quat::Identity()};
  scene.objects = {ball};
  world = collision::make_world(robot, scene, Movement{}, Tolerances{});
  collision::CollisionScratch scratch;
  const auto slack = [&](const MapResult& result, Index f) {
    const JointVector q = result.mapped.position.row(f).transpose();
    return collision::least_slack(world, q, 0, scratch).slack();
  };
  ASSERT_LT(slack(free, 20), -0.01);
  const MapResult clear = solve().value;
  for (Index f = 0; f < 40; ++f) EXPECT_GT(slack(clear, f), -1e-4) << "frame " << f;
}

TEST_F(MapMovement, GoalsOutOfReachAreSaidToBe) {
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    for (const std::size_t tip : {0U, 1U}) goals.tip_position(f, tip) += Vec3(0, 0, 3);
  }
  options.reach_search_starts = 4;
  const auto [result, refusal] = solve();
  ASSERT_FALSE(refusal) << refusal.detail;
  EXPECT_FALSE(goals.reachable(10, 0));
  EXPECT_EQ(result.mapped.status[10], FrameStatus::out_of_reach);
}

TEST_F(MapMovement, WithoutAnyTipThereIsAReason) {
  for (Vec3& tip : goals.tip_position.values) tip = unknown_point();
  EXPECT_EQ(solve().failure.reason, Reason::no_goal);
}

TEST_F(MapMovement, TheSameSeedGivesTheSameBits) {
  const MapResult first = solve(9).value, second = solve(9).value;
  EXPECT_EQ(first.mapped.position, second.mapped.position);
}

TEST_F(MapMovement, ResolvingMovesOnlyWhatIsNearAFinding) {
  const MapResult free = solve().value;
  Finding finding;
  finding.begin_s = 0.30;
  finding.end_s = 0.35;
  MappingProblem problem = make_mapping_problem(robot, goals, world, options);
  problem.clearance.weight *= 10;
  problem.goals[32].elbow += Vec3(0.3, 0, 0);  // something that pulls inside the interval
  const JointPath path = re_solve_path(problem, free.path, {finding}, options, 0.02);
  for (Index f = 0; f < 20; ++f) {
    EXPECT_EQ(path.origin[static_cast<std::size_t>(f)], SampleOrigin::mapped);
    EXPECT_EQ(path.position.row(f), free.path.position.row(f));
  }
}

}  // namespace
}  // namespace morphe::map
