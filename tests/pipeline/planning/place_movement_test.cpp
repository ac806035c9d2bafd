#include "pipeline/planning/place_movement.hpp"

#include <gmock/gmock.h>

#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::planning {
namespace {

using testing::ElementsAre;

scene::ConfiguredObject ball(const std::string& name, const Vec3& position) {
  scene::ConfiguredObject object;
  object.name = name;
  object.shape = "sphere";
  object.size = {0.03};
  object.position = position;
  return object;
}

std::vector<std::string> names_in(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneObject& object : scene.objects) names.push_back(object.name);
  return names;
}

/// world_from_base = T(t) Rz(a) Rx(b), the robot's shoulder where the person's is plus the offsets:
/// worked out with Eigen's rotations, point by point.
TEST(PlaceMovement, GoalsAndBodiesGoIntoTheBaseFrame) {
  test::RobotDemonstration of;
  const double a = 0.7, b = -0.4;
  of.config.placement.rotation = {{"z", a}, {"x", b}};
  of.config.placement.shoulder_offset = Vec3(0.1, -0.2, 0.05);
  of.config.scene.objects = {ball("post", {0.5, 0.6, 0.7}), ball("lamp", {-0.3, 0.2, 0.9})};
  of.config.scene.objects.back().avoid_in_mapping = false;
  const Vec3 offset(0.01, 0.02, -0.03);
  const Scene around = scene_around(of.planner(), {}, of.motion, of.movement);
  const PlacedMovement placed(of.planner(), of.motion, of.movement, around, offset);

  std::vector<Pose> frames;
  robot::forward_kinematics(of.robot, JointVector::Zero(of.first.size()), frames);
  const Vec3 shoulder = frames[static_cast<std::size_t>(of.robot.shoulder_frame)].translation();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(a, Vec3::UnitZ()) * Eigen::AngleAxisd(b, Vec3::UnitX()))
          .toRotationMatrix();
  const Vec3 base =
      of.motion.shoulder[0] + of.config.placement.shoulder_offset + offset - turn * shoulder;
  const auto in_base = [&](const Vec3& point) -> Vec3 { return turn.transpose() * (point - base); };
  for (const std::size_t frame : {0U, 70U, 200U}) {
    for (std::size_t tip = 0; tip < of.robot.tips.size(); ++tip) {
      const auto finger = static_cast<std::size_t>(of.robot.tips[tip].finger);
      EXPECT_LT(
          (placed.goals.tip_position(frame, tip) - in_base(of.motion.tip(frame, finger))).norm(),
          1e-12);
    }
  }
  EXPECT_THAT(names_in(placed.scene), ElementsAre("post", "lamp"));
  EXPECT_LT((placed.scene.objects[0].position[0] - in_base({0.5, 0.6, 0.7})).norm(), 1e-12);
  EXPECT_LT((placed.scene.objects[1].position[0] - in_base({-0.3, 0.2, 0.9})).norm(), 1e-12);
  EXPECT_THAT(names_in(placed.mapping_scene), ElementsAre("post"))
      << "the mapping is not told of the lamp";
  EXPECT_EQ(placed.world.scene, &placed.mapping_scene);
  EXPECT_EQ(placed.problem.frames(), of.motion.time.size());
}

/// What is relative to the base goes with it wherever an offset puts it; the world's stays behind.
TEST(PlaceMovement, BodiesMayStandRelativeToTheBase) {
  test::RobotDemonstration of;
  of.config.scene.objects = {ball("post", {0.5, 0.6, 0.7}), ball("lamp", {-0.3, 0.2, 0.9})};
  of.config.scene.objects[1].relative_to = scene::ReferenceFrame::base;
  const Scene around = scene_around(of.planner(), {}, of.motion, of.movement);
  EXPECT_THAT(names_in(around), ElementsAre("post"));
  const PlacedMovement here(of.planner(), of.motion, of.movement, around, Vec3::Zero());
  const PlacedMovement there(of.planner(), of.motion, of.movement, around, Vec3(0.1, 0, 0));
  EXPECT_EQ(here.missing_support, "");
  EXPECT_THAT(names_in(here.scene), ElementsAre("post", "lamp"));
  EXPECT_THAT(names_in(here.mapping_scene), ElementsAre("post", "lamp"));
  EXPECT_EQ(here.scene.objects[1].position[0], Vec3(-0.3, 0.2, 0.9));
  EXPECT_EQ(there.scene.objects[1].position[0], Vec3(-0.3, 0.2, 0.9));
  EXPECT_NEAR((here.scene.objects[0].position[0] - there.scene.objects[0].position[0]).norm(), 0.1,
              1e-12);
  const Vec3 shoulder = here.frames.base_from_world * of.motion.shoulder[0];
  EXPECT_LT((here.frames.shoulder - shoulder).norm(), 1e-12);

  of.config.scene.objects[1].relative_to = scene::ReferenceFrame::table;
  const PlacedMovement nowhere(of.planner(), of.motion, of.movement, around, Vec3::Zero());
  EXPECT_EQ(nowhere.missing_support,
            "lamp is placed relative to the table, which does not exist in this movement");
}

TEST(PlaceMovement, TheMappingKnowsTheTargetIfItIsToStayClearOfIt) {
  for (const bool clear : {false, true}) {
    test::RobotDemonstration of;
    of.config.map.avoid_target = clear;
    Demonstration beside;
    SceneObject cup;
    cup.name = "cup";
    cup.shape = Shape::sphere;
    cup.size = {0.02};
    cup.time = {0};
    cup.position = {of.motion.tip(200, 1)};
    cup.orientation = {Quat::Identity()};
    beside.objects = {cup};
    const Scene around = scene_around(of.planner(), beside, of.motion, of.movement);
    EXPECT_EQ(of.movement.target, "cup");
    const PlacedMovement placed(of.planner(), of.motion, of.movement, around, Vec3::Zero());
    EXPECT_EQ(placed.mapping_scene.objects.size(), clear ? 1U : 0U);
  }
}

/// An arm that cannot move holds its tips beside the goals by as much as its base stands beside its
/// place, so that the mean of the frames' objectives is least where the offset undoes that.
TEST(PlaceMovement, TheOffsetFindsBackWhereTheGoalsWereMade) {
  test::RobotDemonstration of;
  RobotModel table = of.robot;
  table.lower = of.last.array() - 1e-6;
  table.upper = of.last.array() + 1e-6;
  const robot::Robot still(table);
  for (std::size_t i = 0; i < of.motion.time.size(); ++i) {
    for (std::size_t f = 0; f < kFingerCount; ++f) of.motion.tip(i, f) = of.motion.tip(200, f);
  }
  const Vec3 beside(0.02, -0.015, 0.01);
  of.config.placement.shoulder_offset = beside;
  of.config.map.base_offset.limit_m = 0.04;
  of.config.map.base_offset.weight = 0;
  const planning::PlanningInputs planner{of.config, still};
  const Scene around = scene_around(planner, {}, of.motion, of.movement);
  const Vec3 offset = choose_offset(planner, of.motion, of.movement, around, 5);
  EXPECT_LT((offset + beside).norm(), 0.0015) << offset.transpose();
  of.config.map.base_offset.limit_m = 0.012;
  const Vec3 limited = choose_offset(planner, of.motion, of.movement, around, 5);
  EXPECT_LT((limited - Vec3(-0.012, 0.012, -0.01)).norm(), 0.0015) << limited.transpose();
  of.config.map.base_offset.weight = 1e9;
  EXPECT_EQ(choose_offset(planner, of.motion, of.movement, around, 5), Vec3::Zero())
      << "where moving the base is dear it stays";
}

}  // namespace
}  // namespace morphe::planning
