#include "core/collision/close_holes.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/collision/constants.hpp"

namespace morphe::collision {
namespace {

/// Neighbours of each vertex along edges with an odd number of triangles, which are the boundaries
/// of holes. Every vertex has an even number of them.
using BoundaryEdges = std::map<int, std::set<int>>;

void toggle_edge(BoundaryEdges& rims, int a, int b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    const auto vertex = rims.try_emplace(from).first;
    if (!vertex->second.insert(to).second) vertex->second.erase(to);
    if (vertex->second.empty()) rims.erase(vertex);
  }
}

BoundaryEdges boundary_edges(const SceneObject& mesh) {
  std::vector<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax({triangle[k], triangle[(k + 1) % 3]}));
  }
  std::ranges::sort(edges);
  BoundaryEdges rims;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 == 1) toggle_edge(rims, edge->first, edge->second);
    edge = next;
  }
  return rims;
}

/// Removes the loop with the fewest vertices through the first edge from `rims`, and returns it.
std::vector<int> extract_boundary_loop(BoundaryEdges& rims) {
  const int first = rims.begin()->first, second = *rims.begin()->second.begin();
  toggle_edge(rims, first, second);
  std::map<int, int> predecessor = {{second, second}};
  for (std::deque<int> next = {second}; !predecessor.contains(first); next.pop_front()) {
    for (const int corner : rims[next.front()]) {
      if (predecessor.try_emplace(corner, next.front()).second) next.push_back(corner);
    }
  }
  std::vector<int> rim = {first};
  while (rim.back() != second) {
    const int corner = predecessor[rim.back()];
    toggle_edge(rims, rim.back(), corner);
    rim.push_back(corner);
  }
  return rim;
}

/// Returns the triangles that close a hole. Each one cuts off the vertex of the remaining rim whose
/// neighbours are nearest to each other, so that a slit is closed from its ends.
std::vector<Eigen::Vector3i> fill_hole(const std::vector<Vec3>& vertices, std::vector<int> rim) {
  std::vector<Eigen::Vector3i> lid;
  while (rim.size() >= 3) {
    const std::ptrdiff_t count = std::ssize(rim);
    const auto squared_gap = [&](std::ptrdiff_t k) {
      return (vertices[rim[(k + count - 1) % count]] - vertices[rim[(k + 1) % count]])
          .squaredNorm();
    };
    std::ptrdiff_t cut = 0;
    for (int k = 1; k < count; ++k) {
      if (squared_gap(k) < squared_gap(cut)) cut = k;
    }
    lid.push_back({rim[(cut + count - 1) % count], rim[cut], rim[(cut + 1) % count]});
    rim.erase(rim.begin() + cut);
  }
  return lid;
}

double hole_width(const std::vector<Vec3>& vertices, const std::vector<int>& rim,
                  const std::vector<Eigen::Vector3i>& lid) {
  double area = 0, length = 0;
  for (const Eigen::Vector3i& t : lid) {
    const Vec3& corner = vertices[t[0]];
    area += 0.5 * (vertices[t[1]] - corner).cross(vertices[t[2]] - corner).norm();
  }
  for (int k = 0; k < std::ssize(rim); ++k)
    length += (vertices[rim[k]] - vertices[rim[(k + 1) % rim.size()]]).norm();
  return 4 * area / length;
}

}  // namespace

std::vector<int> first_equal_points(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(
      order, {}, [&](int k) { return std::tuple(points[k].x(), points[k].y(), points[k].z()); });
  for (int k = 0; k < std::ssize(order); ++k) {
    const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

void weld(SceneObject& mesh) {
  std::vector<Vec3> cells;
  for (const Vec3& vertex : mesh.vertices)
    cells.push_back((vertex / kWeldTolerance_m).array().round());
  const std::vector<int> first = first_equal_points(cells);
  int kept = 0;
  std::vector<int> number(first.size());
  for (int k = 0; k < std::ssize(first); ++k) {
    if (first[k] == k) mesh.vertices[kept] = mesh.vertices[k];
    number[k] = first[k] == k ? kept++ : number[first[k]];
  }
  mesh.vertices.resize(kept);
  for (Eigen::Vector3i& t : mesh.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  std::erase_if(mesh.triangles, [](const Eigen::Vector3i& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

void close_holes(SceneObject& mesh, double max_width_m) {
  BoundaryEdges rims = boundary_edges(mesh);
  while (!rims.empty()) {
    const std::vector<int> rim = extract_boundary_loop(rims);
    const std::vector<Eigen::Vector3i> lid = fill_hole(mesh.vertices, rim);
    if (hole_width(mesh.vertices, rim, lid) >= max_width_m) continue;
    mesh.triangles.insert(mesh.triangles.end(), lid.begin(), lid.end());
  }
}

}  // namespace morphe::collision
