#pragma once

#include "core/motion/geometry.hpp"
#include "core/motion/scene.hpp"

namespace morphe::collision {

struct MeshSolid;  // mesh_solid.hpp

/// What distances are measured from: an object and, if it is a mesh, that mesh made ready. A mesh
/// without it is broken and counts as 1 m deep everywhere.
struct Solid {
  Solid(const SceneObject& of, const MeshSolid* ready = nullptr) : object(of), mesh(ready) {}

  const SceneObject& object;
  const MeshSolid* mesh;
};

/// Points within `radius` of the segment from–to, in one common frame [m]. from == to is a sphere.
struct CapsuleBody {
  Vec3 from, to;
  double radius = 0;
};

/// Signed distance of two bodies, > 0 apart, < 0 how deep the first's deepest point lies inside the
/// second. Moving the first by a small u changes the distance by normal · u; where the deepest
/// point sits on a crease inside the second (as near to one face as to another) the change is
/// smaller but the normal still points along it, and where the change is zero (a capsule right
/// through a plate) the normal is that of the side on which most of the capsule's axis lies.
struct Separation {
  double distance = 0;
  Vec3 on_first, on_second;  ///< nearest points (of a capsule: on its surface)
  Vec3 normal;               ///< unit, from the second to the first
};

/// distance = |p - q| - r1 - r2 with p, q the nearest points of the two segments. Exact, closed
/// form. Where the axes touch, the normal is their common perpendicular.
Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second);

/// Signed distance of a point given in the solid's frame, < 0 inside [m], and its unit gradient.
double signed_distance(const Solid& solid, const Vec3& point, Vec3& gradient);
/// No more than that; of a mesh the distance from its box, -infinity in it.
double signed_distance_at_least(const Solid& solid, const Vec3& point);

/// Radius about the object's centre that holds all of it [m].
double bounding_radius(const Solid& solid);

/// distance = min over the capsule's segment of the solid's signed distance, minus the capsule's
/// radius. Convex along the segment: closed form for sphere and capsule, for box and cylinder found
/// to 1e-9 m; for a mesh see capsule_mesh(). The pose is common_from_solid.
Separation capsule_solid(const CapsuleBody& first, const Solid& solid, const Pose& pose);

}  // namespace morphe::collision
