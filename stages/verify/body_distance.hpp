#pragma once

#include "stages/verify/mesh.hpp"

namespace morphe::verify {

/// An object of the scene at a pose in the base frame. All must outlive it.
struct PlacedBody {
  const SceneObject& object;
  const Mesh& mesh;  ///< of a mesh
  const Pose& pose;  ///< base_from_object
};

/// Computes the signed distance of two objects with valid shapes [m]: convex_gap() for two that are
/// no meshes. The triangles of a mesh count as convex bodies, of which the least distance counts;
/// a point inside the solid of a mesh, which is the centre of the other object or a vertex of the
/// other mesh, counts with its depth. From `enough` on, the result is a lower bound; a
/// mesh that overlaps by more than 10 mm may overlap by more than the result.
double body_distance(const PlacedBody& a, const PlacedBody& b, double enough);

}  // namespace morphe::verify
