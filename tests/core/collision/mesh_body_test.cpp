// Overlap and distance of the shapes themselves, on boxes whose distance is plain to see.
#include "core/collision/mesh_body.hpp"

#include <gtest/gtest.h>

namespace morphe::collision {
namespace {

/// A box about the origin, of triangles that share corners.
SceneObject corner_box(const Vec3& half) {
  SceneObject mesh;
  mesh.shape = Shape::mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.emplace_back((k & 1 ? 1 : -1) * half.x(), (k & 2 ? 1 : -1) * half.y(),
                               (k & 4 ? 1 : -1) * half.z());
  for (const auto& [a, b, c, d] : {std::array{0, 1, 3, 2},
                                   {4, 6, 7, 5},
                                   {0, 4, 5, 1},
                                   {2, 3, 7, 6},
                                   {0, 2, 6, 4},
                                   {1, 5, 7, 3}}) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  }
  return mesh;
}

Pose moved_along_x(double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return pose;
}

TEST(MeshBody, DistancesAreThoseOfTheShapes) {
  const MeshBody one(corner_box({0.1, 0.1, 0.1})), other(corner_box({0.05, 0.02, 0.02}));
  EXPECT_NEAR(one.distance(other, moved_along_x(0.165)), 0.015, 1e-9);
  EXPECT_FALSE(one.overlaps(other, moved_along_x(0.1501)));
  EXPECT_TRUE(one.overlaps(other, moved_along_x(0.1499)));
  EXPECT_EQ(one.distance(other, moved_along_x(0.14)), 0);
}

TEST(MeshBody, ABodyInAnotherOverlapsIt) {
  const MeshBody one(corner_box({0.1, 0.1, 0.1})), other(corner_box({0.02, 0.02, 0.02}));
  EXPECT_TRUE(one.overlaps(other, Pose::Identity()));
  EXPECT_TRUE(other.overlaps(one, Pose::Identity()));
  EXPECT_NEAR(one.depth({0.09, 0, 0}), 0.01, 1e-9);
  EXPECT_NEAR(one.depth({0.13, 0, 0}), -0.03, 1e-9);
}

}  // namespace
}  // namespace morphe::collision
