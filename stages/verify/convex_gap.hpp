#pragma once

#include <array>

#include "core/motion/scene.hpp"

namespace morphe::verify {

/// A sphere, box, cylinder or capsule of the scene, or a triangle, in the base frame.
struct ConvexShape {
  const SceneObject* object = nullptr;  ///< null for a triangle
  Pose pose = Pose::Identity();
  std::array<Vec3, 3> corners{};  ///< of a triangle
};

/// Returns the largest gap between parallel planes that separate two convex bodies [m], < 0 if they
/// overlap: their distance, or minus the least translation that separates them. Separated bodies
/// are compared by Wolfe's algorithm for the point of least norm among the differences of their
/// points, to 1e-9 m. For bodies that overlap, the direction is searched, for a triangle only among
/// the axes, its normal and the cross products of edges: the result may be deeper than they are by
/// the error of this search, never less deep.
double convex_gap(const ConvexShape& a, const ConvexShape& b);

}  // namespace morphe::verify
