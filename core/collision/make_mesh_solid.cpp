#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <utility>

#include "core/collision/close_holes.hpp"
#include "core/collision/constants.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

using Corners = std::array<int, 3>;

/// Returns the triangles with equal vertices merged, without those that degenerate.
std::vector<Corners> weld_corners(const SceneObject& mesh) {
  const std::vector<int> first = first_equal_points(mesh.vertices);
  std::vector<Corners> triangles;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Corners corners = {first[t[0]], first[t[1]], first[t[2]]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      triangles.push_back(corners);
  }
  return triangles;
}

/// An edge of one triangle, with the smaller vertex index first.
struct HalfEdge {
  int low, high, triangle;
  auto edge() const { return std::pair(low, high); }
};

/// Returns the edges of all triangles, sorted by edge.
std::vector<HalfEdge> half_edges_of(const std::vector<Corners>& triangles) {
  std::vector<HalfEdge> half_edges;
  for (int t = 0; t < std::ssize(triangles); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      half_edges.push_back({low, high, t});
    }
  }
  std::ranges::stable_sort(half_edges, {}, &HalfEdge::edge);
  return half_edges;
}

int root_of(std::vector<int>& parent, int t) {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

/// Returns the part of each triangle and the number of parts, numbered by their first triangle.
std::vector<int> parts_of(int triangles, const std::vector<HalfEdge>& half_edges, int& count) {
  std::vector<int> parent(triangles);
  std::iota(parent.begin(), parent.end(), 0);
  for (int k = 1; k < std::ssize(half_edges); ++k) {
    if (half_edges[k].edge() != half_edges[k - 1].edge()) continue;
    const int a = root_of(parent, half_edges[k - 1].triangle);
    const int b = root_of(parent, half_edges[k].triangle);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<int> part(triangles);
  count = 0;
  for (int t = 0; t < triangles; ++t) {
    const int root = root_of(parent, t);
    part[t] = root == t ? count++ : part[root];
  }
  return part;
}

Vec3 centre_of(const MeshSolid::Triangle& t) { return (t.a + t.b + t.c) / 3; }

/// Builds the tree of boxes of the triangles [first, first + count) and returns its root. A node is
/// split at the median of the triangles' centres, along the axis in which they extend furthest.
int build(MeshSolid& solid, int first, int count) {
  const auto begin = solid.triangles.begin() + first, end = begin + count;
  MeshSolid::Node node;
  node.low = Vec3::Constant(kInfinity);
  node.high = -node.low;
  Vec3 low = node.low, high = node.high;  // of the triangles' centres
  for (auto t = begin; t != end; ++t) {
    node.low = node.low.cwiseMin(t->a).cwiseMin(t->b).cwiseMin(t->c);
    node.high = node.high.cwiseMax(t->a).cwiseMax(t->b).cwiseMax(t->c);
    low = low.cwiseMin(centre_of(*t));
    high = high.cwiseMax(centre_of(*t));
  }
  const int root = static_cast<int>(std::ssize(solid.nodes));
  solid.nodes.push_back(node);
  if (count <= kMaxLeafTriangles) {
    solid.nodes.back().first = first;
    solid.nodes.back().count = count;
    return root;
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const auto& a, const auto& b) {
    return centre_of(a)[axis] < centre_of(b)[axis];
  });
  const int left = build(solid, first, half), right = build(solid, first + half, count - half);
  solid.nodes[root].left = left;
  solid.nodes[root].right = right;
  return root;
}

}  // namespace

std::string mesh_problem(const SceneObject& mesh) {
  for (const Vec3& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a vertex is not finite";
  }
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= std::ssize(mesh.vertices))
      return "a triangle refers to a vertex that does not exist";
  }
  return weld_corners(mesh).empty() ? "the mesh has no triangles" : "";
}

MeshSolid make_mesh_solid(const SceneObject& mesh) {
  MeshSolid solid;
  const std::vector<Corners> triangles = weld_corners(mesh);
  const int count = static_cast<int>(std::ssize(triangles));
  const std::vector<HalfEdge> half_edges = half_edges_of(triangles);
  int parts = 0;
  const std::vector<int> part = parts_of(count, half_edges, parts);
  solid.closed.assign(parts, 1);
  for (auto side = half_edges.begin(); side != half_edges.end();) {
    const auto next =
        std::ranges::upper_bound(side, half_edges.end(), side->edge(), {}, &HalfEdge::edge);
    if ((next - side) % 2 == 1) solid.closed[part[side->triangle]] = 0;
    side = next;
  }
  for (int t = 0; t < count; ++t) {
    const auto& [a, b, c] = triangles[t];
    solid.triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], part[t]});
    for (const int k : triangles[t]) solid.radius = std::max(solid.radius, mesh.vertices[k].norm());
  }
  build(solid, 0, count);
  return solid;
}

bool is_open(const MeshSolid& mesh) { return !std::ranges::all_of(mesh.closed, std::identity()); }

std::shared_ptr<const MeshSolid> mesh_solid_of(const SceneObject& object, const MeshCache& ready) {
  if (object.shape != Shape::mesh) return nullptr;
  for (const CachedMesh& mesh : ready) {
    if (mesh.vertices == object.vertices && mesh.triangles == object.triangles) return mesh.solid;
  }
  if (!mesh_problem(object).empty()) return nullptr;
  return std::make_shared<const MeshSolid>(make_mesh_solid(object));
}

void add_to_cache(const SceneObject& object, MeshCache& ready) {
  if (std::shared_ptr<const MeshSolid> solid = mesh_solid_of(object, ready))
    ready.push_back({object.vertices, object.triangles, std::move(solid)});
}

}  // namespace morphe::collision
