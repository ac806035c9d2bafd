#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"

namespace morphe::collision {

/// A triangle mesh made ready for distances, in its object's frame. Triangles hang together in
/// parts by the edges they share. A part is closed if every edge has an even number of triangles;
/// what it encloses is solid, however its triangles are turned, cavities included: no arm gets into
/// one but through a wall. Any other part is a sheet without thickness: load_mesh() puts lids on
/// holes that nothing fits through, so that what is open was meant to be.
struct MeshSolid {
  struct Triangle {
    Vec3 a, b, c;
    int part = 0;
  };
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0;  ///< triangles of a leaf
    int left = 0, right = 0;   ///< of the others; count = 0
  };
  std::vector<Triangle> triangles;  ///< sorted by leaf
  std::vector<Node> nodes;          ///< the first is the root; none: no triangles
  std::vector<char> closed;         ///< by part
  double radius = 0;                ///< about the frame's origin [m]
};

/// "" or what keeps the mesh from being one: no triangles, a corner that does not exist, a vertex
/// that is no number.
std::string mesh_problem(const SceneObject& mesh);

/// The mesh must have no problem.
MeshSolid make_mesh_solid(const SceneObject& mesh);

/// Meshes that were made ready before, found again by their vertices and triangles.
struct ReadyMesh {
  std::vector<Vec3> vertices;
  std::vector<Eigen::Vector3i> triangles;
  std::shared_ptr<const MeshSolid> solid;
};
using ReadyMeshes = std::vector<ReadyMesh>;

/// An object's mesh made ready, from `ready` if it is there; null for other shapes and for a mesh
/// with a problem.
std::shared_ptr<const MeshSolid> mesh_solid_of(const SceneObject& object,
                                               const ReadyMeshes& ready = {});
/// Adds an object's mesh, if it has one without a problem.
void make_ready(const SceneObject& object, ReadyMeshes& ready);

/// True if a part of the mesh is a sheet.
bool is_open(const MeshSolid& mesh);

bool inside(const MeshSolid& mesh, const Vec3& point);

/// Signed distance of a point and its gradient, < 0 inside. Exact; how deep counts to the nearest
/// surface, one inside the solid too.
double mesh_distance(const MeshSolid& mesh, const Vec3& point, Vec3& gradient);
/// No more than that, at little cost: the distance from the mesh's box, -infinity in it.
double mesh_distance_at_least(const MeshSolid& mesh, const Vec3& point);

/// Capsule given in the mesh's frame. Exact while its segment is outside; where the segment is in
/// the solid, up to 5 % + 10 um deeper than it is, never less deep.
Separation capsule_mesh(const CapsuleBody& capsule, const MeshSolid& mesh);

}  // namespace morphe::collision
