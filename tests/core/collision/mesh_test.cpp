#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/collision/continuous_check.hpp"
#include "tests/core/collision/meshes.hpp"
#include "tests/core/collision/random_bodies.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::collision {
namespace {

SceneObject box_of(const Vec3& size) {
  SceneObject box;
  box.shape = Shape::box;
  box.size = {size.x(), size.y(), size.z()};
  return box;
}

TEST(Mesh, BoxOfTrianglesIsTheBox) {
  RandomBodies random(61);
  int inside_count = 0, sunk = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 size(random.uniform(0.02, 0.4), random.uniform(0.02, 0.4),
                    random.uniform(0.02, 0.4));
    const MeshObject mesh = box_mesh(size);
    const SceneObject box = box_of(size);
    const Vec3 point = random.point(0.2);
    Vec3 mesh_gradient, box_gradient;
    const double expected = signed_distance(box, point, box_gradient);
    EXPECT_NEAR(signed_distance(mesh.ready(), point, mesh_gradient), expected, 1e-12);
    EXPECT_LT((mesh_gradient - box_gradient).norm(), 1e-6);
    EXPECT_LE(signed_distance_lower_bound(mesh.ready(), point), expected + 1e-12);
    inside_count += expected < 0;

    const Pose pose = random.pose(0.2);
    const CapsuleBody body = random.capsule(0.2);
    const Separation got = capsule_solid(body, mesh.ready(), pose),
                     want = capsule_solid(body, box, pose);
    const double axis = want.distance + body.radius;
    if (axis > 1e-9) {
      EXPECT_NEAR(got.distance, want.distance, 1e-9);
      EXPECT_LT((got.on_first - got.on_second - got.distance * got.normal).norm(), 1e-9);
    } else {
      ++sunk;
      EXPECT_LE(got.distance, want.distance + 1e-9);
      EXPECT_GE(got.distance, want.distance + 0.05 * axis - 1.1e-5);
    }
  }
  EXPECT_GT(inside_count, 100);
  EXPECT_GT(sunk, 300);
}

TEST(Mesh, DistanceToAllTrianglesIsTheLeast) {
  RandomBodies random(62);
  const MeshObject mesh = torus_mesh(0.2, 0.07, 24, 12);
  for (int k = 0; k < 300; ++k) {
    const CapsuleBody body = random.capsule(0.4);
    const Separation got = capsule_solid(body, mesh.ready(), Pose::Identity());
    double least = std::numeric_limits<double>::infinity();
    for (const MeshSolid::Triangle& t : mesh.solid->triangles) {
      for (int s = 0; s <= 40; ++s) {
        // Points spread over the triangle and along the axis: never nearer than what was found.
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const Vec3 point = t.a + u * (t.b - t.a) + v * (t.c - t.a);
        const Vec3 along = body.to - body.from;
        const double at =
            std::clamp((point - body.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (body.from + at * along - point).norm());
      }
    }
    EXPECT_LE(got.distance, least - body.radius + 1e-12);
    if (got.distance + body.radius > 0) {
      EXPECT_GT(got.distance, least - body.radius - 0.02);
    }
  }
}

TEST(Mesh, InsideOfATorusIsInsideTheTube) {
  RandomBodies random(63);
  const MeshObject mesh = torus_mesh(0.2, 0.07, 96, 48);
  int inside_count = 0;
  for (int k = 0; k < 5000; ++k) {
    const Vec3 p = random.point(0.3);
    const double from_tube = std::hypot(std::hypot(p.x(), p.y()) - 0.2, p.z());
    if (std::abs(from_tube - 0.07) < 0.002) continue;  // the polygons' sagitta
    EXPECT_EQ(is_inside(*mesh.solid, p), from_tube < 0.07);
    inside_count += from_tube < 0.07;
  }
  EXPECT_GT(inside_count, 300);
  EXPECT_FALSE(is_inside(*mesh.solid, Vec3::Zero()));  // the hole
}

TEST(Mesh, PointsInTheAxesOfSymmetryAreToldToo) {
  // Rays along axes and diagonals run through edges and corners.
  const MeshObject mesh = box_mesh(Vec3::Constant(0.2));
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const Vec3 point = 0.06 * Vec3(x, y, z);
        EXPECT_EQ(is_inside(*mesh.solid, point), point.cwiseAbs().maxCoeff() < 0.1) << point;
      }
    }
  }
}

/// The hand in the middle of something closed is never free, however it is made.
TEST(Mesh, NothingClosedIsHollow) {
  const CapsuleBody hand{{-0.02, 0, 0}, {0.02, 0, 0}, 0.01};
  const auto free = [&](const MeshObject& mesh) {
    return capsule_solid(hand, mesh.ready(), Pose::Identity()).distance > 0;
  };
  const MeshObject closed = box_mesh(Vec3::Constant(0.4));
  EXPECT_FALSE(free(closed));
  // All triangles turned inside out.
  SceneObject turned = closed;
  for (Eigen::Vector3i& t : turned.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(free(mesh_object(turned.vertices, turned.triangles)));
  // Some of them: closed all the same.
  for (std::size_t k = 0; k < turned.triangles.size(); k += 3) {
    std::swap(turned.triangles[k][0], turned.triangles[k][1]);
  }
  EXPECT_FALSE(free(mesh_object(turned.vertices, turned.triangles)));
  // Thick walls: the cavity's surface points inwards, or does not.
  for (const bool inwards : {true, false}) {
    MeshObject thick = closed;
    append(thick, box_mesh(Vec3::Constant(0.3)), Vec3::Zero(), inwards);
    EXPECT_FALSE(free(thick));
  }
  // Corners that are written out for every triangle, as STL does.
  SceneObject loose = closed;
  loose.vertices.clear();
  for (Eigen::Vector3i& t : loose.triangles) {
    for (int k = 0; k < 3; ++k) {
      loose.vertices.push_back(closed.vertices[static_cast<std::size_t>(t[k])]);
      t[k] = static_cast<int>(loose.vertices.size()) - 1;
    }
  }
  EXPECT_FALSE(free(mesh_object(loose.vertices, loose.triangles)));
  EXPECT_FALSE(is_open(*closed.solid));
  // Between two boxes of one mesh there is room.
  MeshObject two = box_mesh(Vec3::Constant(0.1));
  for (Vec3& vertex : two.vertices) vertex.y() += 0.2;
  append(two, box_mesh(Vec3::Constant(0.1)), Vec3(0, -0.2, 0), false);
  EXPECT_TRUE(free(two));
}

/// The hand reaches into a bowl until it meets a wall.
TEST(Mesh, OpenOnesAreSheets) {
  const auto distance = [](const MeshObject& mesh, double z) {
    return capsule_solid({{-0.02, 0, z}, {0.02, 0, z}, 0.01}, mesh.ready(), Pose::Identity())
        .distance;
  };
  const MeshObject bowl = box_mesh(Vec3::Constant(0.4), 5);  // open above
  ASSERT_TRUE(is_open(*bowl.solid));
  EXPECT_NEAR(distance(bowl, 0.1), 0.2 - 0.02 - 0.01, 1e-12);
  EXPECT_NEAR(distance(bowl, -0.195), -0.005, 1e-12);
  EXPECT_NEAR(distance(bowl, -0.2), -0.01, 1.1e-5);
  EXPECT_NEAR(distance(bowl, -0.205), -0.005, 1e-12);
  // A closed part of the same mesh stays solid.
  MeshObject both = bowl;
  append(both, box_mesh(Vec3::Constant(0.1)), Vec3::Zero(), false);
  EXPECT_LT(distance(both, 0), -0.04);
  EXPECT_TRUE(is_open(*both.solid));
}

TEST(Mesh, BrokenOnesAreNamedAndCollide) {
  const CapsuleBody body{{5, 0, 0}, {5, 0, 0.1}, 0.01};
  const auto broken = [&](const MeshObject& mesh, const std::string& problem) {
    EXPECT_EQ(mesh_problem(mesh), problem);
    EXPECT_EQ(mesh.solid, nullptr);
    EXPECT_LT(capsule_solid(body, mesh.ready(), Pose::Identity()).distance, -0.5);
  };
  broken(mesh_object({}, {}), "the mesh has no triangles");
  broken(mesh_object({Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 1}}), "the mesh has no triangles");
  broken(mesh_object({Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 2}}),
         "a triangle refers to a vertex that does not exist");
  broken(mesh_object({Vec3::Zero(), Vec3::UnitX(), unknown_point()}, {{0, 1, 2}}),
         "a vertex is not finite");
}

TEST(Mesh, WorldPreparesItAndCertifiesPastIt) {
  RobotModel table = two_link_arm();
  table.capsules.push_back({"forearm", 1, Vec3::Zero(), Vec3(0.5, 0, 0), 0.01, false});
  const robot::Robot robot(table);
  Scene scene;
  MeshObject wall = box_mesh(Vec3(0.001, 0.001, 0.5));
  wall.position = {Vec3(0.8, 0, 0)};
  scene.objects = {wall};
  const CollisionWorld world = make_world(robot, scene, {}, {});
  MeshCache ready;
  add_to_cache(box_mesh(Vec3(0.001, 0.001, 0.4)), ready);
  add_to_cache(wall, ready);
  const CollisionWorld again = make_world(robot, scene, {}, {}, ready);
  EXPECT_EQ(again.meshes[0], ready[1].solid) << "made once";
  EXPECT_EQ(world.meshes[0]->radius, ready[1].solid->radius);
  CollisionScratch scratch;
  const JointVector from = Eigen::Vector2d(-0.1, 0), to = Eigen::Vector2d(0.08, 0);
  EXPECT_GT(least_slack(world, from, 0, scratch).slack(), 0.03);
  EXPECT_GT(least_slack(world, to, 0, scratch).slack(), 0.03);
  EXPECT_EQ(check_motion(world, straight_motion(from, to, 0, 0), scratch).verdict,
            MotionVerdict::colliding);
  const JointVector before = Eigen::Vector2d(-0.03, 0);
  EXPECT_EQ(check_motion(world, straight_motion(from, before, 0, 0), scratch).verdict,
            MotionVerdict::free);
}

}  // namespace
}  // namespace morphe::collision
