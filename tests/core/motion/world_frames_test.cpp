#include "core/motion/world_frames.hpp"
#include "core/motion/find_world_frames.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace morphe {
namespace {

SceneObject body(const std::string& name, Shape shape, std::vector<double> size, const Vec3& at) {
  SceneObject object;
  object.name = name;
  object.shape = shape;
  object.size = std::move(size);
  object.time = {0};
  object.position = {at};
  object.orientation = {Quat::Identity()};
  return object;
}

TEST(WorldFrames, AreThoseOfTableAndTargetAsTheMovementBegins) {
  Scene scene;
  scene.objects = {body("table", Shape::box, {1, 2, 0.04}, {0.5, 0, 0.7}),
                   body("cup", Shape::cylinder, {0.03, 0.1}, {0, 0, 0})};
  // A quarter turn lays the table's upper side to the base's x.
  scene.objects[0].orientation = {Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()))};
  scene.objects[1].time = {0, 2};
  scene.objects[1].position = {Vec3(0, 0, 0), Vec3(0.4, 0, 0)};
  scene.objects[1].orientation.resize(2, Quat::Identity());
  const Movement movement{0, 1, 3, {}, "cup"};
  const Pose base_from_world(Eigen::Translation3d(1, 2, 3));

  const WorldFrames frames =
      find_world_frames(scene, movement, base_from_world, Vec3(0.1, 0.2, 0.3));

  EXPECT_TRUE(frames.base_from_table.translation().isApprox(Vec3(0.52, 0, 0.7), 1e-12));
  EXPECT_TRUE(frames.base_from_table.linear().col(2).isApprox(Vec3::UnitX(), 1e-12));
  EXPECT_TRUE(frames.base_from_target.translation().isApprox(Vec3(0.2, 0, 0), 1e-12));
  EXPECT_EQ(frames.base_from_world.translation(), Vec3(1, 2, 3));
  EXPECT_EQ(frames.shoulder, Vec3(0.1, 0.2, 0.3));
}

TEST(WorldFrames, OfWhatIsNotThereAreUnseen) {
  Scene scene;
  scene.objects = {body("table", Shape::sphere, {1}, {0, 0, 0})};
  const WorldFrames frames = find_world_frames(scene, {}, Pose::Identity(), unknown_point());
  EXPECT_FALSE(is_known(frames.base_from_table));
  EXPECT_FALSE(is_known(frames.base_from_target));
  EXPECT_FALSE(is_known(frames.shoulder));
  EXPECT_FALSE(is_known(WorldFrames{}.base_from_world));
}

}  // namespace
}  // namespace morphe
