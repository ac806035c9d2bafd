#pragma once

#include "core/collision/mesh_file.hpp"
#include "tests/core/collision/meshes.hpp"
#include "tests/core/collision/random_bodies.hpp"
#include "tests/core/collision/reference_distance.hpp"

namespace morphe::collision {

/// The hull of points on an ellipsoid about the origin.
inline MeshObject random_hull(RandomBodies& random) {
  const Vec3 axes(random.uniform(0.02, 0.2), random.uniform(0.02, 0.2), random.uniform(0.02, 0.2));
  SceneObject points;
  for (int k = 0; k < 14; ++k) points.vertices.push_back(axes.cwiseProduct(random.direction()));
  // Whatever the others are, the origin is inside.
  for (int k = 0; k < 3; ++k) {
    points.vertices.push_back(axes[k] * Vec3::Unit(k));
    points.vertices.push_back(-axes[k] * Vec3::Unit(k));
  }
  replace_by_convex_hull(points);
  return mesh_object(points.vertices, points.triangles);
}

/// How wrong the distance of a random capsule and solid is: above the truth, below it [m].
struct DistanceError {
  double over = 0, under = 0, uncertain = 0;
};
inline DistanceError random_pair_error(RandomBodies& random, Shape shape, int number) {
  const SceneObject object = shape == Shape::mesh ? random_hull(random) : random.solid(shape);
  const std::shared_ptr<const MeshSolid> mesh = mesh_solid_of(object);
  const Solid solid(object, mesh.get());
  const Pose pose = random.pose(0.3);
  CapsuleBody body = random.capsule(0.5);
  if (number % 7 == 0) body.to = body.from;  // a sphere
  if (number % 11 == 0) body.to = body.from + 1e-6 * random.direction();
  if (number % 13 == 0) {  // along an axis of the solid
    body.to = body.from + random.uniform(0, 0.4) * pose.linear().col(number % 3);
  }
  const double got = capsule_solid(body, solid, pose).distance + body.radius;
  const Pose solid_from_base = pose.inverse();
  const ReferenceDistance truth =
      reference_distance(solid_from_base * body.from, solid_from_base * body.to, object);
  if (truth.upper == 0) return {std::max(got, 0.0), 0, 0};  // how deep is another question
  return {got - truth.upper, truth.lower - got, truth.upper - truth.lower};
}

}  // namespace morphe::collision
