#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

constexpr int kMaxLeafTriangles = 4;  ///< maximum number of triangles of a leaf

using Corners = std::array<int, 3>;

/// Returns the triangles with coincident vertices merged. Triangles with two coincident vertices
/// are degenerate and removed.
std::vector<Corners> weld_corners(const SceneObject& mesh) {
  const auto at = [&](int k) -> const Vec3& { return mesh.vertices[k]; };
  const auto key = [&](int k) { return std::tuple(at(k).x(), at(k).y(), at(k).z()); };
  std::vector<int> order(mesh.vertices.size()), place(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, key);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && at(order[k]) == at(order[k - 1]);
    place[order[k]] = same ? place[order[k - 1]] : order[k];
  }
  std::vector<Corners> triangles;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = place[t[static_cast<int>(k)]];
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      triangles.push_back(corners);
    }
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
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      half_edges.push_back({low, high, static_cast<int>(t)});
    }
  }
  std::ranges::stable_sort(half_edges, {}, &HalfEdge::edge);
  return half_edges;
}

int root_of(std::vector<int>& parent, int t) {
  while (parent[t] != t) {
    t = parent[t] = parent[parent[t]];
  }
  return t;
}

/// Returns the part of each triangle; parts are numbered by their first triangle.
std::vector<int> parts_of(std::size_t triangles, const std::vector<HalfEdge>& half_edges,
                          int& count) {
  std::vector<int> parent(triangles);
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t k = 1; k < half_edges.size(); ++k) {
    if (half_edges[k].edge() != half_edges[k - 1].edge()) continue;
    const int a = root_of(parent, half_edges[k - 1].triangle),
              b = root_of(parent, half_edges[k].triangle);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<int> part(triangles);
  count = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto root = static_cast<std::size_t>(root_of(parent, static_cast<int>(t)));
    part[t] = root == t ? count++ : part[root];
  }
  return part;
}

Vec3 centre_of(const MeshSolid::Triangle& t) { return (t.a + t.b + t.c) / 3; }

/// Builds the tree of boxes by splitting at the median centroid along the longest side of the
/// centroids' bounding box.
int build(MeshSolid& solid, int first, int count) {
  const auto begin = solid.triangles.begin() + first, end = begin + count;
  MeshSolid::Node node;
  node.low = Vec3::Constant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  Vec3 low = node.low, high = node.high;
  for (auto t = begin; t != end; ++t) {
    node.low = node.low.cwiseMin(t->a).cwiseMin(t->b).cwiseMin(t->c);
    node.high = node.high.cwiseMax(t->a).cwiseMax(t->b).cwiseMax(t->c);
    low = low.cwiseMin(centre_of(*t));
    high = high.cwiseMax(centre_of(*t));
  }
  const int at = static_cast<int>(solid.nodes.size());
  solid.nodes.push_back(node);
  if (count <= kMaxLeafTriangles) {
    solid.nodes.back().first = first;
    solid.nodes.back().count = count;
    return at;
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const auto& a, const auto& b) {
    return centre_of(a)[axis] < centre_of(b)[axis];
  });
  const int left = build(solid, first, half), right = build(solid, first + half, count - half);
  solid.nodes[at].left = left;
  solid.nodes[at].right = right;
  return at;
}

}  // namespace

std::string mesh_problem(const SceneObject& mesh) {
  for (const Vec3& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a vertex is not finite";
  }
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= vertices)
      return "a triangle refers to a vertex that does not exist";
  }
  return weld_corners(mesh).empty() ? "the mesh has no triangles" : "";
}

MeshSolid make_mesh_solid(const SceneObject& mesh) {
  MeshSolid solid;
  const std::vector<Corners> triangles = weld_corners(mesh);
  const std::vector<HalfEdge> half_edges = half_edges_of(triangles);
  int parts = 0;
  const std::vector<int> part = parts_of(triangles.size(), half_edges, parts);
  solid.closed.assign(parts, 1);
  for (auto side = half_edges.begin(); side != half_edges.end();) {
    const auto next = std::upper_bound(
        side, half_edges.end(), side->edge(),
        [](const std::pair<int, int>& edge, const HalfEdge& other) { return edge < other.edge(); });
    const auto leaky = static_cast<std::size_t>(side->triangle);
    if ((next - side) % 2 == 1) solid.closed[part[leaky]] = 0;
    side = next;
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto vertex = [&](std::size_t k) { return mesh.vertices[triangles[t][k]]; };
    solid.triangles.push_back({vertex(0), vertex(1), vertex(2), part[t]});
    for (std::size_t k = 0; k < 3; ++k) solid.radius = std::max(solid.radius, vertex(k).norm());
  }
  build(solid, 0, static_cast<int>(solid.triangles.size()));
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
  if (std::shared_ptr<const MeshSolid> solid = mesh_solid_of(object, ready)) {
    ready.push_back({object.vertices, object.triangles, std::move(solid)});
  }
}

}  // namespace morphe::collision
