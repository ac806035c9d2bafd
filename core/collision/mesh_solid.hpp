#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// A triangle mesh preprocessed for distance queries, in its object's frame. Triangles that share
/// edges form parts. A part is closed if every edge has an even number of triangles; its interior
/// is solid, whatever the orientation of its triangles, including cavities, because an arm could
/// only enter them through a wall. Any other part is a sheet without thickness: load_mesh() fills
/// small holes, so that remaining openings are intended.
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
    int left = 0, right = 0;   ///< children of an inner node; count = 0
  };
  std::vector<Triangle> triangles;  ///< sorted by leaf
  std::vector<Node> nodes;          ///< the first is the root; empty if there are no triangles
  std::vector<char> closed;         ///< by part; true if the part is closed
  double radius = 0;                ///< about the frame's origin [m]
};

/// Returns "" or the reason why the mesh is invalid: no triangles, an index of a vertex that does
/// not exist, or a vertex that is not finite.
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

/// Returns an object's preprocessed mesh, from `ready` if it is there, or null for other shapes and
/// invalid meshes.
std::shared_ptr<const MeshSolid> mesh_solid_of(const SceneObject& object,
                                               const MeshCache& ready = {});
/// Adds an object's mesh to the cache if the object has a valid one.
void add_to_cache(const SceneObject& object, MeshCache& ready);

/// Returns true if a part of the mesh is a sheet.
bool is_open(const MeshSolid& mesh);

/// Returns true if a point is inside a closed part of the mesh.
bool is_inside(const MeshSolid& mesh, const Vec3& point);

/// Returns the signed distance of a point and its gradient, < 0 inside. It is exact. The depth is
/// the distance to the nearest surface, including surfaces inside the solid.
double mesh_distance(const MeshSolid& mesh, const Vec3& point, Vec3& gradient);
/// Returns a lower bound of the signed distance at little cost: the distance from the mesh's
/// bounding box, or -infinity within the box.
double mesh_distance_lower_bound(const MeshSolid& mesh, const Vec3& point);

/// Computes the separation of a capsule given in the mesh's frame. It is exact while the capsule's
/// segment is outside; if the segment is inside the solid, the depth is overestimated by up to 5 %
/// + 10 um, and never underestimated.
Separation capsule_mesh(const CapsuleBody& capsule, const MeshSolid& mesh);

}  // namespace morphe::collision
