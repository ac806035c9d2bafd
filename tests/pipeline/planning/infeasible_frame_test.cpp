#include "pipeline/planning/infeasible_frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/check/check_path.hpp"
#include "stages/map/map_movement.hpp"

namespace morphe::planning {
namespace {

using Eigen::Index;

/// The reference robot holds one posture for half a second; its goals are where its fingertips are
/// then, so that a posture is known that meets them.
class FindDeadEnd : public testing::Test {
 protected:
  FindDeadEnd()
      : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {
    posture = JointVector::Zero(static_cast<Index>(robot.joints()));
    posture.head(7) << 1.2, -1.0, -1.6, 1.6, 2.5, 0.7, 0.5;
    posture.tail(15) << 0.1, 0.5, 0.4, 0, 0.3, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3, 0, 0.4, 0.3;
    robot::forward_kinematics(robot, posture, poses);
    goals.tip_position = {kFrames, robot.tips.size(), unknown_point()};
    goals.tip_orientation = {kFrames, robot.tips.size(), unknown_rotation()};
    goals.finger_joint_position = {kFrames, kFingerCount, unknown_point()};
    goals.shoulder_position.assign(kFrames, unknown_point());
    goals.elbow_position = goals.wrist_position = goals.shoulder_position;
    goals.wrist_orientation.assign(kFrames, unknown_rotation());
    for (std::size_t f = 0; f < kFrames; ++f) {
      goals.time.push_back(0.05 * static_cast<double>(f));
      for (const std::size_t tip : {0U, 1U}) {
        goals.tip_position(f, tip) = robot::tip_pose(robot, poses, tip).translation();
      }
    }
    options.starts = 12;
  }

  /// From a path that stands a little beside the posture.
  std::optional<InfeasibleFrame> find() {
    const collision::CollisionWorld world =
        collision::make_world(robot, scene, Movement{}, Tolerances{});
    const JointRows beside =
        (posture.array() + 0.05).matrix().transpose().replicate(static_cast<Index>(kFrames), 1);
    const auto check = [&](const JointPath& path) {
      return check::check_path(world, goals, Movement{}, path, check::CheckOptions{});
    };
    return find_infeasible_frame(map::make_mapping_problem(robot, goals, world, options),
                                 {{beside, std::vector<SampleOrigin>(kFrames), goals.time},
                                  {{0.1, 0.3, Cause::tracking, "thumb_tip", "", 0.01}}},
                                 check, options, 3, holds);
  }

  static constexpr std::size_t kFrames = 11;
  robot::Robot robot;
  JointVector posture;
  std::vector<Pose> poses;
  Scene scene;
  Goals goals;
  map::MapOptions options;
  std::vector<FeasiblePosture> holds;
};

TEST_F(FindDeadEnd, IsNoneWhereAPostureHoldsTheGoals) {
  EXPECT_FALSE(find());
  ASSERT_EQ(holds.size(), 3U);  // beginning, middle and end of the finding
  for (const FeasiblePosture& hold : holds) {
    EXPECT_GE(hold.frame, 2U);
    EXPECT_LE(hold.frame, 6U);
    robot::forward_kinematics(robot, hold.q, poses);
    for (const std::size_t tip : {0U, 1U}) {
      const Vec3 goal = goals.tip_position(hold.frame, tip);
      EXPECT_LT((robot::tip_pose(robot, poses, tip).translation() - goal).norm(), 2e-3);
    }
  }
}

TEST_F(FindDeadEnd, IsAGoalInCollisionInsideABody) {
  SceneObject ball;  // both fingertips are in the middle of it
  ball.name = "ball";
  ball.shape = Shape::sphere;
  ball.size = {0.15};
  ball.position = {goals.tip_position(0, 1)};
  ball.orientation = {Quat::Identity()};
  scene.objects.push_back(ball);
  const std::optional<InfeasibleFrame> end = find();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->reason, Reason::goal_in_collision);
  EXPECT_GT(end->posture_count, 1);
  EXPECT_GT(end->worst_finding.excess, 0);
  EXPECT_TRUE(is_collision(end->worst_finding.cause)) << "as the reason says";
  EXPECT_THAT(detail_of(*end), testing::HasSubstr("the best that reaches the goals has "));
  EXPECT_THAT(detail_of(*end), testing::ContainsRegex("mm too (close to|deep in) ball"));
  if (end->tip_error_if_clear) {
    EXPECT_EQ(end->tip_error_if_clear->cause, Cause::tracking);
    EXPECT_THAT(detail_of(*end), testing::HasSubstr("the best without a collision leaves "));
  }
  EXPECT_TRUE(holds.empty());
}

TEST_F(FindDeadEnd, IsUnreachableWhereTheArmDoesNotGo) {
  for (std::size_t f = 0; f < kFrames; ++f) goals.tip_position(f, 1) += Vec3(2.5, 0, 0);
  const std::optional<InfeasibleFrame> end = find();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->reason, Reason::unreachable);
  EXPECT_NEAR(end->time_s, 0.2, 1e-9);
  EXPECT_EQ(end->worst_finding.cause, Cause::tracking) << "as the reason says";
  EXPECT_THAT(detail_of(*end), testing::HasSubstr("with or without obstacles, leaves "));
  EXPECT_THAT(detail_of(*end), testing::HasSubstr("mm beyond its tolerance"));
}

}  // namespace
}  // namespace morphe::planning
