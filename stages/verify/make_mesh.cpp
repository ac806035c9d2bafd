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
  std::vector<int> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int i, int j) { return less_lexicographic(at(i), at(j)); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && at(order[k]) == at(order[k - 1]);
    place[order[k]] = same ? place[order[k - 1]] : order[k];
  }
  return place;
}

/// An edge of a triangle, lower vertex index first.
struct Edge {
  int low, high, triangle;
};

std::vector<Edge> sorted_edges(const std::vector<Corners>& triangles) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      edges.push_back({low, high, static_cast<int>(t)});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low, e.high, e.triangle); });
  return edges;
}

/// Returns the least triangle of the component that contains t, with path compression.
int find_root(std::vector<int>& above, int t) {
  int top = t;
  while (above[top] != top) top = above[top];
  while (t != top) t = std::exchange(above[t], top);
  return top;
}

Vec3 triangle_centroid(const Mesh::Triangle& t) { return (t.a + t.b + t.c) / 3; }

Mesh::Cluster bounding_cluster(const Mesh& mesh, std::size_t begin, std::size_t end) {
  Mesh::Cluster cluster{begin, end, Vec3::Zero(), mesh.triangles[begin].a, mesh.triangles[begin].a};
  for (std::size_t k = begin; k < end; ++k) {
    const Mesh::Triangle& t = mesh.triangles[k];
    cluster.low = cluster.low.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    cluster.high = cluster.high.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  cluster.centre = 0.5 * (cluster.low + cluster.high);
  for (std::size_t k = begin; k < end; ++k) {
    const Mesh::Triangle& t = mesh.triangles[k];
    for (const Vec3& corner : {t.a, t.b, t.c})
      cluster.radius = std::max(cluster.radius, (corner - cluster.centre).norm());
  }
  return cluster;
}

/// Groups the triangles by the cells of a grid, of which about sqrt(n) are occupied if the
/// triangles are distributed evenly over a surface.
void cluster(Mesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  mesh.ball = bounding_cluster(mesh, 0, count);
  const double along = std::ceil(std::pow(static_cast<double>(count), 0.25) / 2);
  const double side = std::max((mesh.ball.high - mesh.ball.low).maxCoeff() / along, 1e-9);
  const auto cell = [side, low = mesh.ball.low](const Mesh::Triangle& t) {
    const Vec3 at = ((triangle_centroid(t) - low) / side).array().floor();
    return std::tuple(at.x(), at.y(), at.z());
  };
  std::ranges::stable_sort(mesh.triangles, {}, cell);
  for (std::size_t begin = 0; begin < count;) {
    std::size_t end = begin + 1;
    while (end < count && cell(mesh.triangles[end]) == cell(mesh.triangles[begin])) ++end;
    mesh.clusters.push_back(bounding_cluster(mesh, begin, end));
    begin = end;
  }
}

}  // namespace

Mesh make_mesh(const SceneObject& object) {
  Mesh mesh;
  const std::vector<int> place = merged_vertex_indices(object.vertices);
  std::vector<Corners> triangles;
  for (const Eigen::Vector3i& t : object.triangles) {
    const Corners at = {place[t[0]], place[t[1]], place[t[2]]};
    if (at[0] != at[1] && at[1] != at[2] && at[2] != at[0]) triangles.push_back(at);
  }
  if (triangles.empty()) return mesh;
  const std::vector<Edge> edges = sorted_edges(triangles);
  const auto shared = [&](std::size_t k) {
    return k > 0 && edges[k].low == edges[k - 1].low && edges[k].high == edges[k - 1].high;
  };
  std::vector<int> above(triangles.size());
  std::iota(above.begin(), above.end(), 0);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!shared(k)) continue;
    const int one = find_root(above, edges[k - 1].triangle),
              other = find_root(above, edges[k].triangle);
    above[std::max(one, other)] = std::min(one, other);
  }
  std::vector<int> part(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto first = static_cast<std::size_t>(find_root(above, static_cast<int>(t)));
    if (first == t) {
      part[t] = static_cast<int>(mesh.watertight.size());
      mesh.watertight.push_back(1);
    } else {
      part[t] = part[first];
    }
  }
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && shared(end)) ++end;
    const int owner = part[edges[begin].triangle];
    if ((end - begin) % 2 == 1) mesh.watertight[owner] = 0;
    begin = end;
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) { return object.vertices[triangles[t][k]]; };
    mesh.triangles.push_back({corner(0), corner(1), corner(2), part[t]});
  }
  cluster(mesh);
  return mesh;
}

}  // namespace morphe::verify
