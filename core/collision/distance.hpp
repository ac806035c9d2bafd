#pragma once

#include "core/motion/geometry.hpp"
#include "core/motion/scene.hpp"

namespace morphe::collision {

struct MeshSolid;  // mesh_solid.hpp

/// The geometry for distance queries: an object and, if it is a mesh, the preprocessed mesh. Both
/// must outlive it. A mesh without preprocessed data is invalid: every point counts as 1 m inside.
struct Solid {
  Solid(const SceneObject& scene_object, const MeshSolid* mesh_solid = nullptr)
      : object(scene_object), mesh(mesh_solid) {}

  const SceneObject& object;
  const MeshSolid* mesh;
};

/// A capsule: the points within `radius` of the segment from–to [m]. It is a sphere if from == to.
/// The bodies of a query are given in one common frame.
struct CapsuleBody {
  Vec3 from, to;
  double radius = 0;
};

/// The signed distance of two bodies: > 0 if they are separated; < 0 is the depth of the first
/// body's deepest point in the second. Moving the first body by a small u changes the distance by
/// normal · u. The change is smaller if the deepest point is equally near to two faces of the
/// second body; the normal then points in the direction of the largest change. If no motion changes
/// the distance (a capsule through a plate), the normal points to the capsule's longer part.
struct Separation {
  double distance = 0;       ///< [m]
  Vec3 on_first, on_second;  ///< nearest points on the surfaces; in a penetration, the deepest ones
  Vec3 normal;               ///< unit, from the second to the first
};

/// The closest points of two segments.
struct ClosestPoints {
  Vec3 on_first, on_second;
  double squared_distance = 0;
};
/// Returns the closest points of the segments a–b and c–d, each of which may be a single point.
ClosestPoints closest_points_of_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                         const Vec3& d);

/// Computes distance = |p - q| - r1 - r2, with p, q the nearest points of the two segments and r1,
/// r2 the radii. If the segments intersect, the normal is their common perpendicular.
Separation capsule_capsule(const CapsuleBody& first, const CapsuleBody& second);

/// Returns the signed distance [m] of a point in the solid's frame, < 0 inside, and its gradient.
double signed_distance(const Solid& solid, const Vec3& point, Vec3& gradient);
/// Returns a lower bound of the signed distance [m]: mesh_distance_lower_bound() for a mesh, the
/// signed distance itself for other shapes.
double signed_distance_lower_bound(const Solid& solid, const Vec3& point);

/// Returns the radius of a sphere about the object's centre that contains it [m].
double bounding_radius(const Solid& solid);

/// Computes distance = min over the capsule's segment of the solid's signed distance, minus the
/// capsule's radius. Spheres and capsules have a closed form. For boxes and cylinders, whose signed
/// distance is convex along the segment, the error is up to 1e-9 m. For meshes see capsule_mesh().
/// `pose` is common_from_solid.
Separation capsule_solid(const CapsuleBody& first, const Solid& solid, const Pose& pose);

/// Computes the separation of two objects, whose poses are common_from_solid. For convex shapes see
/// convex_distance(). A mesh counts as its triangles, which are exact if they do not touch the
/// other object; a closed part also contains what is inside. If they do, the depth is the largest
/// of the triangles' own overlaps and of the depths of the meshes' vertices and the other object's
/// centre: an estimate, which may be too small between vertices. An invalid mesh is 1 m inside
/// everything.
Separation solid_solid(const Solid& first, const Pose& first_pose, const Solid& second,
                       const Pose& second_pose);
/// Returns a lower bound of the distance of two objects, from a sphere about each of them [m].
double solid_distance_lower_bound(const Solid& first, const Pose& first_pose, const Solid& second,
                                  const Pose& second_pose);

}  // namespace morphe::collision
