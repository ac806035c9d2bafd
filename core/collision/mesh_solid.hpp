#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// A triangle mesh preprocessed for distance queries, in its object's frame. Triangles that share
/// edges form parts. A part is closed if every edge has an even number of triangles. A closed part
/// is solid inside, whatever the orientation of its triangles; so are its cavities, because an arm
/// could only enter them through a wall. Any other part is a sheet without thickness: load_mesh()
/// fills small holes, so that remaining openings are intended.
struct MeshSolid {
  /// A triangle and the part to which it belongs.
  struct Triangle {
    Vec3 a, b, c;
    int part = 0;
  };
  /// A node of the tree of bounding boxes.
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0;  ///< triangles of a leaf
    int left = 0, right = 0;   ///< children of an inner node, which has count = 0
  };
  std::vector<Triangle> triangles;  ///< those of a leaf are consecutive
  std::vector<Node> nodes;          ///< the first is the root; empty if there are no triangles
  std::vector<char> closed;         ///< [parts] 1 if the part is closed
  double radius = 0;                ///< largest distance from the frame's origin [m]
};

/// Returns "" or why a mesh is invalid: no triangles, or vertices that are missing or not finite.
std::string mesh_problem(const SceneObject& mesh);

/// Preprocesses a mesh, which must be valid.
MeshSolid make_mesh_solid(const SceneObject& mesh);

/// A mesh that was preprocessed before, found by its vertices and triangles.
struct CachedMesh {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::shared_ptr<const MeshSolid> solid;
};
/// Meshes that were preprocessed before.
using MeshCache = std::vector<CachedMesh>;

/// Returns an object's preprocessed mesh, from `ready` if it is there; null if the object has no
/// valid mesh.
std::shared_ptr<const MeshSolid> mesh_solid_of(const SceneObject& object,
                                               const MeshCache& ready = {});
/// Adds an object's mesh to the cache if the object has a valid one.
void add_to_cache(const SceneObject& object, MeshCache& ready);

/// Returns true if a part of the mesh is a sheet.
bool is_open(const MeshSolid& mesh);

/// Returns true if a point is inside a closed part of the mesh.
bool is_inside(const MeshSolid& mesh, const Vec3& point);

/// Returns the exact signed distance of a point [m], < 0 inside, and its gradient. A depth is the
/// distance to the nearest triangle, also of a triangle within the solid.
double mesh_distance(const MeshSolid& mesh, const Vec3& point, Vec3& gradient);
/// Returns a lower bound of mesh_distance(): the distance from the mesh's bounding box, or
/// -infinity within the box.
double mesh_distance_lower_bound(const MeshSolid& mesh, const Vec3& point);

/// Computes the separation of a capsule given in the mesh's frame. It is exact if the capsule's
/// segment is outside. If the segment enters the solid, its depth is overestimated by up to 5 % +
/// 10 um, and never underestimated.
Separation capsule_mesh(const CapsuleBody& capsule, const MeshSolid& mesh);

}  // namespace morphe::collision
