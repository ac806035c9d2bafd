#include <gtest/gtest.h>

#include <algorithm>

#include "core/collision/mesh_solid.hpp"
#include "tests/core/collision/random_bodies.hpp"
#include "tests/support/projected_distance.hpp"

namespace morphe::collision {
namespace {

TEST(SolidSolid, DistanceIsThatOfTheNearestPointsOfTheTwoSolids) {
  RandomBodies random(51);
  int separated = 0;
  for (int k = 0; k < 3000; ++k) {
    const SceneObject a = random.solid(kSolids[k % 4]), b = random.solid(kSolids[k / 4 % 4]);
    const Pose pose_a = random.pose(0.5), pose_b = random.pose(0.5);
    const Separation got = solid_solid(a, pose_a, b, pose_b);
    const double upper_m = projected_distance(a, pose_a, b, pose_b);
    EXPECT_LE(got.distance, upper_m + 1e-9) << k;
    EXPECT_LE(solid_distance_lower_bound(a, pose_a, b, pose_b), got.distance + 1e-9);
    EXPECT_NEAR(got.normal.norm(), 1, 1e-12);
    if (upper_m < 1e-4) continue;
    ++separated;
    EXPECT_NEAR(got.distance, upper_m, 1e-4 * upper_m + 1e-7) << k;
    EXPECT_NEAR((got.on_first - got.on_second - got.distance * got.normal).norm(), 0, 1e-4);
    EXPECT_NEAR((pose_a * nearest_in(a, pose_a.inverse() * got.on_first) - got.on_first).norm(), 0,
                1e-8);
  }
  EXPECT_GT(separated, 1500);
}

TEST(SolidSolid, CapsulesAgreeWithCapsuleSolid) {
  RandomBodies random(52);
  for (int k = 0; k < 1000; ++k) {
    const SceneObject capsule = random.solid(Shape::capsule), other = random.solid(kSolids[k % 4]);
    const Pose pose = random.pose(0.4), other_pose = random.pose(0.3);
    const Vec3 arm = 0.5 * capsule.size[1] * pose.linear().col(2);
    const CapsuleBody body{pose.translation() - arm, pose.translation() + arm, capsule.size[0]};
    const double expected_m = capsule_solid(body, other, other_pose).distance;
    const double got_m = solid_solid(capsule, pose, other, other_pose).distance;
    if (expected_m > -capsule.size[0]) {
      EXPECT_NEAR(got_m, expected_m, 5e-8) << k;
    }
    // Deeper, the way out may be longer than the depth of one point, but not shorter.
    EXPECT_LE(got_m, expected_m + 5e-8) << k;
  }
}

TEST(SolidSolid, DepthIsTheShortestWayOut) {
  RandomBodies random(53);
  for (int k = 0; k < 500; ++k) {
    const SceneObject a = random.solid(kSolids[k % 4]), b = random.solid(kSolids[k / 4 % 4]);
    const Pose pose_a = random.pose(0.15), pose_b = random.pose(0.15);
    const Separation got = solid_solid(a, pose_a, b, pose_b);
    if (got.distance >= 0) continue;
    Pose out = pose_a;
    out.translation() -= (got.distance - 1e-9) * got.normal;
    EXPECT_GE(solid_solid(a, out, b, pose_b).distance, -1e-9);
    for (int ray = 0; ray < 50; ++ray) {
      // No shorter way leads out, as far as the search for the direction is exact.
      if (a.shape == Shape::cylinder || b.shape == Shape::cylinder) break;
      out.translation() = pose_a.translation() - 0.99 * got.distance * random.direction();
      EXPECT_LE(solid_solid(a, out, b, pose_b).distance, 1e-9);
    }
  }
}

/// A cup that stands 1.3 mm deep in a table, and one that is tilted by a degree on it.
TEST(SolidSolid, ACupInATableIsAsDeepAsItsLowestPoint) {
  RandomBodies random(54);
  SceneObject cup = random.solid(Shape::cylinder), table = random.solid(Shape::box);
  cup.size = {0.035, 0.1};
  table.size = {1, 0.8, 0.04};
  const Pose table_pose = make_pose(Vec3(0.1, 0, -0.02), Quat::Identity());
  for (const double tilt : {0.0, kRadPerDegree}) {
    const Pose cup_pose =
        make_pose(Vec3(0.2, 0.1, 0.05 * std::cos(tilt) + 0.035 * std::sin(tilt) - 0.0013),
                  Quat(Eigen::AngleAxisd(tilt, Vec3::UnitX())));
    EXPECT_NEAR(solid_solid(cup, cup_pose, table, table_pose).distance, -0.0013, 1e-9);
    const SceneObject mesh = box_mesh(table);
    const MeshSolid solid = make_mesh_solid(mesh);
    EXPECT_NEAR(solid_solid(cup, cup_pose, {mesh, &solid}, table_pose).distance, -0.0013, 1e-9);
  }
}

TEST(SolidSolid, MeshesOfBoxesAreBoxes) {
  RandomBodies random(55);
  int apart = 0, inside = 0;
  for (int k = 0; k < 600; ++k) {
    const SceneObject box = random.solid(Shape::box), other = random.solid(kSolids[k % 4]);
    const SceneObject second_box = random.solid(Shape::box);
    const SceneObject mesh = box_mesh(box), second_mesh = box_mesh(second_box);
    const MeshSolid solid = make_mesh_solid(mesh), second_solid = make_mesh_solid(second_mesh);
    const Pose pose = random.pose(0.3), other_pose = random.pose(0.3);
    const double expected_m = solid_solid(box, pose, other, other_pose).distance;
    const double both_m = solid_solid(box, pose, second_box, other_pose).distance;
    const Separation got = solid_solid({mesh, &solid}, pose, other, other_pose);
    const double turned_m = solid_solid(other, other_pose, {mesh, &solid}, pose).distance;
    const double meshes_m =
        solid_solid({mesh, &solid}, pose, {second_mesh, &second_solid}, other_pose).distance;
    EXPECT_EQ(got.distance, turned_m);
    EXPECT_EQ(got.distance > 0, expected_m > 0) << k;
    EXPECT_EQ(meshes_m > 0, both_m > 0) << k;
    if (expected_m > 0) {
      EXPECT_NEAR(got.distance, expected_m, 5e-8) << k;
    }
    if (both_m > 0) {
      EXPECT_NEAR(meshes_m, both_m, 5e-8) << k;
    }
    apart += expected_m > 0;
    inside += expected_m < -0.05;
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(inside, 50);
}

TEST(SolidSolid, AnInvalidMeshAlwaysCollides) {
  RandomBodies random(56);
  SceneObject mesh = random.solid(Shape::mesh);
  const SceneObject ball = random.solid(Shape::sphere);
  EXPECT_EQ(solid_solid(mesh, random.pose(5), ball, random.pose(1)).distance, -1);
  EXPECT_EQ(solid_solid(ball, random.pose(5), mesh, random.pose(1)).distance, -1);
}

}  // namespace
}  // namespace morphe::collision
