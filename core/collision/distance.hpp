#pragma once

#include "core/motion/geometry.hpp"
#include "core/motion/scene.hpp"

namespace morphe::collision {

struct MeshSolid;  // mesh_solid.hpp

/// The geometry for distance queries: an object and, if it is a mesh, the preprocessed mesh. A mesh
/// without preprocessed data is invalid, and every point counts as 1 m inside it.
struct Solid {
  Solid(const SceneObject& of, const MeshSolid* ready = nullptr) : object(of), mesh(ready) {}

  const SceneObject& object;
  const MeshSolid* mesh;
};

/// A capsule: the points within `radius` of the segment from–to, in one common frame [m]. from ==
/// to is a sphere.
struct CapsuleBody {
  Vec3 from, to;
  double radius = 0;
};

/// The signed distance of two bodies: > 0 if separated, < 0 the penetration depth of the first
/// body's deepest point in the second. Moving the first body by a small u changes the distance by
/// normal · u. If the deepest point is on the medial axis of the second body (equally near to two
/// faces), the change is smaller but the normal still points along it. If the change is zero (a
/// capsule through a plate), the normal is that of the side on which most of the capsule's axis is.
struct Separation {
  double distance = 0;
  Vec3 on_first, on_second;  ///< nearest points (of a capsule: on its surface)
  Vec3 normal;               ///< unit, from the second to the first
};

/// Computes distance = |p - q| - r1 - r2, with p, q the nearest points of the two segments, exactly
/// and in closed form. If the axes intersect, the normal is their common perpendicular.
Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second);

/// Returns the signed distance of a point given in the solid's frame, < 0 inside [m], and its unit
/// gradient.
double signed_distance(const Solid& solid, const Vec3& point, Vec3& gradient);
/// Returns a lower bound of the signed distance; for a mesh the distance from its bounding box, or
/// -infinity within the box.
double signed_distance_lower_bound(const Solid& solid, const Vec3& point);

/// Returns the radius of a sphere about the object's centre that contains it [m].
double bounding_radius(const Solid& solid);

/// Computes distance = min over the capsule's segment of the solid's signed distance, minus the
/// capsule's radius. The signed distance is convex along the segment: sphere and capsule have a
/// closed form, box and cylinder are solved to 1e-9 m; for a mesh see capsule_mesh(). `pose` is
/// common_from_solid.
Separation capsule_solid(const CapsuleBody& first, const Solid& solid, const Pose& pose);

}  // namespace morphe::collision
