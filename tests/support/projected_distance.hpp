#pragma once

#include <algorithm>

#include "core/motion/scene.hpp"

namespace morphe {

/// Returns the point of a solid, in its own frame, that is nearest to a point.
inline Vec3 nearest_in(const SceneObject& solid, const Vec3& p) {
  const std::vector<double>& size = solid.size;
  if (solid.shape == Shape::box) {
    const Vec3 half = 0.5 * Vec3(size[0], size[1], size[2]);
    return p.cwiseMax(-half).cwiseMin(half);
  }
  if (solid.shape == Shape::cylinder) {
    const double share = std::min(1.0, size[0] / p.head<2>().norm());
    return {share * p.x(), share * p.y(), std::clamp(p.z(), -0.5 * size[1], 0.5 * size[1])};
  }
  const double half = solid.shape == Shape::sphere ? 0 : 0.5 * size[1];
  const Vec3 axis(0, 0, std::clamp(p.z(), -half, half));
  const double share = std::min(1.0, size[0] / (p - axis).norm());
  return axis + share * (p - axis);
}

/// Returns the distance of two convex solids by alternating projections: an upper bound.
inline double projected_distance(const SceneObject& a, const Pose& pose_a, const SceneObject& b,
                                 const Pose& pose_b) {
  Vec3 on_a = pose_a.translation(), on_b = pose_b.translation();
  for (int k = 0; k < 3000; ++k) {
    on_b = pose_b * nearest_in(b, pose_b.inverse() * on_a);
    on_a = pose_a * nearest_in(a, pose_a.inverse() * on_b);
  }
  return (on_a - on_b).norm();
}

/// Returns a box as a closed mesh of 12 triangles.
inline SceneObject box_mesh(const SceneObject& box) {
  SceneObject mesh = box;
  mesh.shape = Shape::mesh;
  mesh.size.clear();
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(0.5 * Vec3(k & 1 ? box.size[0] : -box.size[0],
                                       k & 2 ? box.size[1] : -box.size[1],
                                       k & 4 ? box.size[2] : -box.size[2]));
  const int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  }
  return mesh;
}

}  // namespace morphe
