#include "stages/map/reachability.hpp"

#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/map_options.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::map {
namespace {

/// One frame, whose goals are where the reference robot's own tips are in some posture.
class ReachableFrames : public testing::Test {
 protected:
  ReachableFrames()
      : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {
    world = collision::make_world(robot, scene, {}, {});
    problem.robot = &robot;
    problem.objective = default_objective();
    problem.world = &world;
    problem.time = {0};
    problem.goals.resize(1);
  }

  void set_goals(const JointVector& q, std::size_t tips, std::size_t frame = 0) {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    problem.goals[frame].tip_position.assign(robot.tips.size(), unknown_point());
    for (std::size_t tip = 0; tip < tips; ++tip) {
      problem.goals[frame].tip_position[tip] = robot::tip_pose(robot, poses, tip).translation();
    }
  }

  bool reachable(const JointVector& near, int starts) {
    return reachable_frames(problem, near.transpose(), {starts, 1e-4, {}}, 1).front();
  }

  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
};

TEST_F(ReachableFrames, WhereSomePostureHoldsThem) {
  std::mt19937_64 random(1);
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  for (int k = 0; k < 20; ++k) {
    const JointVector there = random_position(robot, random, 0.9);
    for (const std::size_t tips : {std::size_t{2}, robot.tips.size()}) {
      set_goals(there, tips);
      EXPECT_TRUE(reachable(there, 1)) << "from the posture itself, " << k;
      EXPECT_TRUE(reachable(there + 0.02 * (middle - there), 1)) << "from beside it, " << k;
      EXPECT_TRUE(reachable(middle, 256)) << "from anywhere, " << k;
    }
  }
}

TEST_F(ReachableFrames, NotBeyondTheArmNorApartFromEachOther) {
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  set_goals(middle, 2);
  const Vec3 thumb = problem.goals[0].tip_position[0];
  problem.goals[0].tip_position[1] = thumb + Vec3(0, 0, 0.5);  // the hand is not so large
  EXPECT_FALSE(reachable(middle, 64));
  problem.goals[0].tip_position = {Vec3(3, 0, 0)};
  problem.goals[0].tip_position.resize(robot.tips.size(), unknown_point());
  EXPECT_FALSE(reachable(middle, 64));
}

TEST_F(ReachableFrames, NotBeyondALimit) {
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  set_goals(middle, 1);
  for (const double beyond : {-0.05, 0.05}) {
    robot::Robot stiff = robot;
    stiff.lower = stiff.upper = middle;  // only the last joint of the thumb turns
    stiff.upper[9] += 0.1;
    problem.robot = world.robot = &stiff;
    JointVector there = middle;
    there[9] += 0.05 + beyond;
    set_goals(there, 1);
    EXPECT_TRUE(reachable(middle, 1));
    there[9] += beyond;
    set_goals(there, 1);
    EXPECT_FALSE(reachable(middle, 16));
  }
}

/// Two tips move apart until the hand is too small for it, and back, while a third is only seen in
/// between: every frame is judged as it is by itself.
TEST_F(ReachableFrames, OfAMovementAsOneByOne) {
  constexpr std::size_t kFrames = 61;
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  problem.time.resize(kFrames);
  problem.goals.resize(kFrames);
  for (std::size_t f = 0; f < kFrames; ++f) {
    problem.time[f] = 0.01 * static_cast<double>(f);
    set_goals(middle, f % 20 < 10 ? 2 : 3, f);
    const double apart = 0.1 - 0.4 * std::pow(static_cast<double>(f) / 30 - 1, 2);
    problem.goals[f].tip_position[1] += Vec3(0, 0, std::max(0.0, apart));
  }
  const JointRows near = middle.transpose().replicate(kFrames, 1);
  const std::vector<bool> together = reachable_frames(problem, near, {64, 1e-4, {}}, 1);

  const MappingProblem movement = problem;
  int out = 0;
  for (std::size_t f = 0; f < kFrames; ++f) {
    problem.time = {movement.time[f]};
    problem.goals = {movement.goals[f]};
    EXPECT_EQ(together[f], reachable(middle, 64)) << f;
    out += together[f] ? 0 : 1;
  }
  EXPECT_GT(out, 5);
  EXPECT_LT(out, 55);
  EXPECT_TRUE(together.front() && together.back());
}

}  // namespace
}  // namespace morphe::map
