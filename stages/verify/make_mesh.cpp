#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "stages/verify/mesh.hpp"

namespace morphe::verify {
namespace {

using Corners = std::array<int, 3>;

bool less_lexicographic(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Returns, for each vertex, the index of the first vertex at the same position.
std::vector<int> merged_vertex_indices(const std::vector<Vec3>& vertices) {
  const auto at = [&](int k) -> const Vec3& { return vertices[k]; };
  std::vector<int> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int i, int j) { return less_lexicographic(at(i), at(j)); });
  for (int k = 0; k < std::ssize(order); ++k) {
    const bool same = k > 0 && at(order[k]) == at(order[k - 1]);
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

/// An edge of a triangle, lower vertex index first.
struct Edge {
  int low, high, triangle;
};

std::vector<Edge> sorted_edges(const std::vector<Corners>& triangles) {
  std::vector<Edge> edges;
  for (int t = 0; t < std::ssize(triangles); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      edges.push_back({low, high, t});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low, e.high, e.triangle); });
  return edges;
}

/// Returns the lowest triangle of the part joined so far that contains t, with path compression.
int find_root(std::vector<int>& parent, int t) {
  int root = t;
  while (parent[root] != root) root = parent[root];
  while (t != root) t = std::exchange(parent[t], root);
  return root;
}

Vec3 triangle_centroid(const Mesh::Triangle& t) { return (t.a + t.b + t.c) / 3; }

Mesh::Cluster bounding_cluster(const Mesh& mesh, int begin, int end) {
  Mesh::Cluster cluster{begin, end, Vec3::Zero(), mesh.triangles[begin].a, mesh.triangles[begin].a};
  for (int k = begin; k < end; ++k) {
    const Mesh::Triangle& t = mesh.triangles[k];
    cluster.low = cluster.low.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    cluster.high = cluster.high.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  cluster.centre = 0.5 * (cluster.low + cluster.high);
  for (int k = begin; k < end; ++k) {
    const Mesh::Triangle& t = mesh.triangles[k];
    for (const Vec3& corner : {t.a, t.b, t.c})
      cluster.radius = std::max(cluster.radius, (corner - cluster.centre).norm());
  }
  return cluster;
}

/// Groups the triangles by the cells of a grid, of which about sqrt(n) are occupied if the
/// triangles are distributed evenly over a surface.
void cluster_triangles(Mesh& mesh) {
  const int count = static_cast<int>(mesh.triangles.size());
  mesh.ball = bounding_cluster(mesh, 0, count);
  const double cells_along = std::ceil(std::pow(count, 0.25) / 2);
  const double side = std::max((mesh.ball.high - mesh.ball.low).maxCoeff() / cells_along, 1e-9);
  const auto cell = [side, low = mesh.ball.low](const Mesh::Triangle& t) {
    const Vec3 index = ((triangle_centroid(t) - low) / side).array().floor();
    return std::tuple(index.x(), index.y(), index.z());
  };
  std::ranges::stable_sort(mesh.triangles, {}, cell);
  for (int begin = 0, end = 1; begin < count; begin = end++) {
    while (end < count && cell(mesh.triangles[end]) == cell(mesh.triangles[begin])) ++end;
    mesh.clusters.push_back(bounding_cluster(mesh, begin, end));
  }
}

}  // namespace

Mesh make_mesh(const SceneObject& object) {
  Mesh mesh;
  const std::vector<int> first_vertex = merged_vertex_indices(object.vertices);
  std::vector<Corners> triangles;
  for (const Eigen::Vector3i& t : object.triangles) {
    const Corners c = {first_vertex[t[0]], first_vertex[t[1]], first_vertex[t[2]]};
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) triangles.push_back(c);
  }
  if (triangles.empty()) return mesh;
  const std::vector<Edge> edges = sorted_edges(triangles);
  const auto repeats_edge = [&](int k) {
    return k > 0 && edges[k].low == edges[k - 1].low && edges[k].high == edges[k - 1].high;
  };
  std::vector<int> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (int k = 0; k < std::ssize(edges); ++k) {
    if (!repeats_edge(k)) continue;
    const int a = find_root(parent, edges[k - 1].triangle);
    const int b = find_root(parent, edges[k].triangle);
    parent[std::max(a, b)] = std::min(a, b);
  }
  int components = 0;
  std::vector<int> component(triangles.size());
  for (int t = 0; t < std::ssize(triangles); ++t) {
    const int root = find_root(parent, t);
    component[t] = root == t ? components++ : component[root];
  }
  mesh.watertight.assign(components, 1);
  for (int begin = 0, end = 1; begin < std::ssize(edges); begin = end++) {
    while (end < std::ssize(edges) && repeats_edge(end)) ++end;
    if ((end - begin) % 2 == 1) mesh.watertight[component[edges[begin].triangle]] = 0;
  }
  for (int t = 0; t < std::ssize(triangles); ++t) {
    const auto corner = [&](int k) { return object.vertices[triangles[t][k]]; };
    mesh.triangles.push_back({corner(0), corner(1), corner(2), component[t]});
  }
  cluster_triangles(mesh);
  return mesh;
}

}  // namespace morphe::verify
