#include "core/collision/close_holes.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace morphe::collision {
namespace {

constexpr double kWeldTolerance_m = 1e-6;

/// Neighbours of each vertex along edges with an odd number of triangles, which are the boundaries
/// of holes. Every vertex has an even number of them.
using BoundaryEdges = std::map<int, std::set<int>>;

void toggle_edge(BoundaryEdges& rims, int a, int b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    const auto at = rims.try_emplace(from).first;
    if (!at->second.insert(to).second) at->second.erase(to);
    if (at->second.empty()) rims.erase(at);
  }
}

BoundaryEdges boundary_edges(const SceneObject& mesh) {
  std::vector<std::pair<int, int>> edges;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax({t[k], t[(k + 1) % 3]}));
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

/// Removes a boundary loop from the edges and returns it: the one with the fewest vertices through
/// the first edge.
std::vector<int> extract_boundary_loop(BoundaryEdges& rims) {
  const int first = rims.begin()->first, second = *rims.begin()->second.begin();
  toggle_edge(rims, first, second);
  std::map<int, int> before = {{second, second}};
  for (std::deque<int> next = {second}; !before.contains(first); next.pop_front()) {
    for (const int corner : rims[next.front()]) {
      if (before.try_emplace(corner, next.front()).second) next.push_back(corner);
    }
  }
  std::vector<int> rim = {first};
  while (rim.back() != second) {
    const int corner = before[rim.back()];
    toggle_edge(rims, rim.back(), corner);
    rim.push_back(corner);
  }
  return rim;
}

/// Triangulates a hole by repeatedly cutting off the vertex whose neighbours are nearest to each
/// other. A slit is thus closed from its ends.
std::vector<Eigen::Vector3i> fill_hole(const std::vector<Vec3>& vertices, std::vector<int> rim) {
  std::vector<Eigen::Vector3i> lid;
  while (rim.size() >= 3) {
    const std::size_t count = rim.size();
    const auto across = [&](std::size_t k) {
      return (vertices[rim[(k + count - 1) % count]] - vertices[rim[(k + 1) % count]])
          .squaredNorm();
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < count; ++k) {
      if (across(k) < across(best)) best = k;
    }
    lid.push_back({rim[(best + count - 1) % count], rim[best], rim[(best + 1) % count]});
    rim.erase(rim.begin() + best);
  }
  return lid;
}

double width_of(const std::vector<Vec3>& vertices, const std::vector<int>& rim,
                const std::vector<Eigen::Vector3i>& lid) {
  const auto at = [&](int k) -> const Vec3& { return vertices[k]; };
  double area = 0, length = 0;
  for (const Eigen::Vector3i& t : lid) {
    area += 0.5 * (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm();
  }
  for (std::size_t k = 0; k < rim.size(); ++k) {
    length += (at(rim[k]) - at(rim[(k + 1) % rim.size()])).norm();
  }
  return 4 * area / length;
}

}  // namespace

void weld(SceneObject& mesh) {
  const auto cell = [&](int k) {
    const Vec3 at = (mesh.vertices[k] / kWeldTolerance_m).array().round();
    return std::tuple(at.x(), at.y(), at.z());
  };
  std::vector<int> order(mesh.vertices.size()), first(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, cell);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && cell(order[k]) == cell(order[k - 1]);
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  std::vector<Vec3> kept;
  std::vector<int> number(first.size());
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto one = static_cast<std::size_t>(first[k]);
    if (one == k) {
      number[k] = static_cast<int>(kept.size());
      kept.push_back(mesh.vertices[k]);
    }
    number[k] = number[one];
  }
  mesh.vertices = std::move(kept);
  std::vector<Eigen::Vector3i> triangles;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int k) { return number[t[k]]; };
    const Eigen::Vector3i welded(corner(0), corner(1), corner(2));
    if (welded[0] == welded[1] || welded[1] == welded[2] || welded[2] == welded[0]) continue;
    triangles.push_back(welded);
  }
  mesh.triangles = std::move(triangles);
}

void close_holes(SceneObject& mesh, double widest_m) {
  BoundaryEdges rims = boundary_edges(mesh);
  while (!rims.empty()) {
    const std::vector<int> rim = extract_boundary_loop(rims);
    const std::vector<Eigen::Vector3i> lid = fill_hole(mesh.vertices, rim);
    if (width_of(mesh.vertices, rim, lid) >= widest_m) continue;
    mesh.triangles.insert(mesh.triangles.end(), lid.begin(), lid.end());
  }
}

}  // namespace morphe::collision
