#include "stages/simulate/mjcf_text.hpp"
#include "core/math/rotation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/physics/state.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

SimulatedWorld world_of(const robot::Robot& robot, const Scene& scene) {
  const SimulateOptions options;
  return {
      &robot,       servos_of(robot, options), robot_inertias(robot, options.density), &scene, 0,
      Vec3::UnitZ()};
}

class ShippedRobots : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  }
};

TEST_P(ShippedRobots, StandInTheModelAsTheirTableSays) {
  const robot::Robot robot(robot::shipped_robot(GetParam()));
  const Scene scene{{standing("ball", Shape::sphere, {0.01}, Vec3(5, 5, 5))}};
  const Variation variation{0.8, 0.002, 0.1, Pose(Eigen::Translation3d(5, 5, 5))};
  const physics::Model model(
      mjcf_text(world_of(robot, scene), variation, SimulateOptions(), Environment::scene));
  physics::State state(model);
  std::mt19937 random(7);
  std::vector<Pose> expected;
  for (int k = 0; k < 20; ++k) {
    const JointVector q = robot::random_position(robot, random);
    for (std::size_t f = 0; f < robot.frames.size(); ++f) {
      const RobotModel::Frame& frame = robot.frames[f];
      if (frame.joint >= 0)
        state.set_joint(model.joint(fmt::format("f{}", f)),
                        frame.ratio * q[frame.joint] + frame.offset);
    }
    state.update_poses();
    robot::forward_kinematics(robot, q, expected);
    for (std::size_t f = 0; f < expected.size(); ++f) {
      const Pose found = state.body(model.body(fmt::format("f{}", f)));
      EXPECT_LT((found.matrix() - expected[f].matrix()).cwiseAbs().maxCoeff(), 1e-9)
          << robot.frames[f].name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, ShippedRobots,
                         testing::Values("pa10_dlr_hit2", "gen3_robotiq_2f85", "iiwa14_allegro",
                                         "ur5e_shadow", "xarm7_leap"));

TEST(ModelText, CoupledFramesFollowTheirJoint) {
  if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  RobotModel table = gripper_table();
  table.frames.push_back(
      {"end", 2, Pose(Eigen::Translation3d(0.08, 0, 0)), Vec3::UnitZ(), 2, -1.5, 0.2});
  const robot::Robot robot(table);
  const Plan plan = cup_plan();
  const Variation variation{0.8, 0.002, 0.3, Pose(Eigen::Translation3d(3, 0, 0.1))};
  const SimulateOptions options;
  const physics::Model model(
      mjcf_text(world_of(robot, plan.scene), variation, options, Environment::scene));
  physics::State state(model);
  const std::vector<double> q{0, 0, 0.3};
  for (int j = 0; j < 3; ++j)
    state.set_control(model.actuator(fmt::format("m{}", j)), q[static_cast<std::size_t>(j)]);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(state.step(), std::nullopt);
  EXPECT_NEAR(state.joint(model.joint("f2")), 0.3, 1e-4);
  EXPECT_NEAR(state.joint(model.joint("f3")), -1.5 * 0.3 + 0.2, 1e-3);
}

TEST(ModelText, ATargetStandsOnItsSupport) {
  if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  Plan plan = cup_plan();
  SimulatedWorld world = world_of(gripper(), plan.scene);
  world.up = Vec3(0, 0.6, 0.8);  // a base that is tilted: the cup stands along `up`, far away
  const Pose pose = make_pose(Vec3(3, 0, 0.1), math::shortest_rotation(Vec3::UnitZ(), world.up));
  const physics::Model model(
      mjcf_text(world, {0.8, 0.002, 0.3, pose}, SimulateOptions(), Environment::scene));
  physics::State state(model);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(state.step(), std::nullopt);
  EXPECT_LT((state.body(model.body("target")).matrix() - pose.matrix()).norm(), 1e-3);
}

TEST(ModelText, EveryShapeIsTaken) {
  if (physics::engine_version().empty()) GTEST_SKIP() << "built without MuJoCo";
  Plan plan = cup_plan();
  SceneObject mesh = standing("mesh", Shape::mesh, {}, Vec3(2, 0, 0));
  mesh.vertices = {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0), Vec3(0, 0, 0.1)};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  plan.scene.objects.push_back(mesh);
  plan.scene.objects.push_back(standing("a", Shape::sphere, {0.05}, Vec3(3, 0, 0)));
  plan.scene.objects.push_back(standing("b", Shape::capsule, {0.05, 0.1}, Vec3(4, 0, 0)));
  SimulatedWorld world = world_of(gripper(), plan.scene);
  for (const int target : {0, 2, 3, 4}) {
    world.target = target;
    EXPECT_FALSE(is_static_obstacle(world, static_cast<std::size_t>(target)));
    EXPECT_FALSE(is_static_obstacle(world, 2));  // the mesh
    EXPECT_TRUE(is_static_obstacle(world, 1));   // the table
    const Pose pose(Eigen::Translation3d(5, 0, 0));
    const physics::Model model(
        mjcf_text(world, {0.8, 0.002, 0.3, pose}, SimulateOptions(), Environment::scene));
    physics::State state(model);
    EXPECT_EQ(state.step(), std::nullopt);
    EXPECT_LT((state.body(model.body("target")).translation() - pose.translation()).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace morphe::simulate
