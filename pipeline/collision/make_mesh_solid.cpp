#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>

#include "pipeline/collision/mesh_solid.hpp"

namespace morphe {
namespace {

constexpr int kLeaf = 4;  ///< triangles of a leaf at most

using Corners = std::array<int, 3>;

/// Triangles by corner, corners of one place being one; those with two corners in one place are
/// lines between others' corners, or nothing.
std::vector<Corners> welded(const SceneObject& mesh) {
  std::map<std::array<double, 3>, int> places;
  std::vector<int> place_of;
  for (const Vec3& v : mesh.vertices) {
    const int next = static_cast<int>(place_of.size());
    place_of.push_back(
        places.try_emplace({v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}, next).first->second);
  }
  std::vector<Corners> triangles;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = place_of[static_cast<std::size_t>(t[static_cast<int>(k)])];
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      triangles.push_back(corners);
    }
  }
  return triangles;
}

struct Side {
  int triangle;
  bool forward;  ///< from the lower corner to the higher one
};
using Edges = std::map<std::pair<int, int>, std::vector<Side>>;

Edges edges_of(const std::vector<Corners>& triangles) {
  Edges edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      edges[std::minmax(from, to)].push_back({static_cast<int>(t), from < to});
    }
  }
  return edges;
}

int root_of(std::vector<int>& parent, int t) {
  while (parent[static_cast<std::size_t>(t)] != t) {
    t = parent[static_cast<std::size_t>(t)] =
        parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(t)])];
  }
  return t;
}

/// The part of each triangle; parts are numbered by their first triangle.
std::vector<int> parts_of(std::size_t triangles, const Edges& edges, int& count) {
  std::vector<int> parent(triangles);
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [edge, sides] : edges) {
    for (const Side& side : sides) {
      const int a = root_of(parent, sides.front().triangle), b = root_of(parent, side.triangle);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<int> part(triangles);
  count = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto root = static_cast<std::size_t>(root_of(parent, static_cast<int>(t)));
    part[t] = root == t ? count++ : part[root];
  }
  return part;
}

/// Turns neighbours across an edge of two triangles alike, from each part's first triangle on.
void turn_alike(std::vector<Corners>& triangles, const Edges& edges) {
  std::vector<std::vector<std::pair<int, bool>>> next(triangles.size());
  for (const auto& [edge, sides] : edges) {
    if (sides.size() != 2) continue;
    const bool flip = sides[0].forward == sides[1].forward;
    next[static_cast<std::size_t>(sides[0].triangle)].push_back({sides[1].triangle, flip});
    next[static_cast<std::size_t>(sides[1].triangle)].push_back({sides[0].triangle, flip});
  }
  std::vector<int> turned(triangles.size(), -1), stack;  // -1: not reached
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (turned[first] >= 0) continue;
    turned[first] = 0;
    stack.push_back(static_cast<int>(first));
    while (!stack.empty()) {
      const auto at = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      for (const auto& [other, flip] : next[at]) {
        int& state = turned[static_cast<std::size_t>(other)];
        if (state >= 0) continue;
        state = (turned[at] + (flip ? 1 : 0)) % 2;
        stack.push_back(other);
      }
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (turned[t] == 1) std::swap(triangles[t][1], triangles[t][2]);
  }
}

Vec3 centre_of(const MeshSolid::Triangle& t) { return (t.a + t.b + t.c) / 3; }

/// Halves by the median centre along the longest side of the centres' box.
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
  if (count <= kLeaf) {
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
  solid.nodes[static_cast<std::size_t>(at)].left = left;
  solid.nodes[static_cast<std::size_t>(at)].right = right;
  return at;
}

}  // namespace

std::string mesh_problem(const SceneObject& mesh) {
  for (const Vec3& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a vertex is not a number";
  }
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= vertices) return "a triangle's corner does not exist";
  }
  return welded(mesh).empty() ? "it has no triangles" : "";
}

MeshSolid make_mesh_solid(const SceneObject& mesh) {
  MeshSolid solid;
  std::vector<Corners> triangles = welded(mesh);
  const Edges edges = edges_of(triangles);
  int parts = 0;
  const std::vector<int> part = parts_of(triangles.size(), edges, parts);
  solid.closed.assign(static_cast<std::size_t>(parts), 1);
  for (const auto& [edge, sides] : edges) {
    if (sides.size() % 2 == 0) continue;
    const auto leaky = static_cast<std::size_t>(sides.front().triangle);
    solid.closed[static_cast<std::size_t>(part[leaky])] = 0;
  }
  turn_alike(triangles, edges);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto vertex = [&](std::size_t k) {
      return mesh.vertices[static_cast<std::size_t>(triangles[t][k])];
    };
    solid.triangles.push_back({vertex(0), vertex(1), vertex(2), part[t]});
    for (std::size_t k = 0; k < 3; ++k) solid.radius = std::max(solid.radius, vertex(k).norm());
  }
  build(solid, 0, static_cast<int>(solid.triangles.size()));
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    if (!solid.closed[static_cast<std::size_t>(solid.triangles[t].part)]) {
      solid.open.push_back(static_cast<int>(t));
    }
  }
  return solid;
}

void prepare_meshes(Scene& scene) {
  for (SceneObject& object : scene.objects) {
    if (object.shape != Shape::mesh || object.solid || !mesh_problem(object).empty()) continue;
    object.solid = std::make_shared<const MeshSolid>(make_mesh_solid(object));
  }
}

}  // namespace morphe
