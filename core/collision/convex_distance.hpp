#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::collision {

/// A convex body: the points within `radius` of a core, which is a box (a point or a segment if its
/// sides are 0), a cylinder along the third axis, or a triangle. All is given in one common frame.
struct ConvexBody {
  enum class Core { box, cylinder, triangle };
  Core core = Core::box;
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< unit columns, of boxes and cylinders
  Vec3 half = Vec3::Zero();       ///< half sides of a box; radius, radius and half length
  std::array<Vec3, 3> corners{};  ///< of a triangle
  double radius = 0;              ///< by which the core is grown on all sides [m]
};

/// The signed distance of two convex bodies.
struct ConvexSeparation {
  /// The largest gap between two parallel planes, one bounding each body, that the search found:
  /// never more than the distance, or than minus the least translation that separates the bodies.
  double distance = 0;
  Vec3 on_first = Vec3::Zero(), on_second = Vec3::Zero();  ///< nearest, or deepest, points
  Vec3 normal = Vec3::UnitZ();                             ///< of the planes, from second to first
};

/// Computes max over unit n of min_a n·a - max_b n·b, a in the first and b in the second body. If
/// the cores are apart, this is the distance, found by the algorithm of Gilbert, Johnson and
/// Keerthi to about 1e-8 m. If they overlap, n is the best of the faces' normals, the cross
/// products of edges, and the directions in which shrunk cores are separated: exact for boxes and
/// triangles; for a cylinder, the depth may be overestimated, but never underestimated.
ConvexSeparation convex_distance(const ConvexBody& first, const ConvexBody& second);

}  // namespace morphe::collision
