#include <algorithm>
#include <cmath>
#include <queue>

#include "core/collision/constants.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

struct Nearest {
  double squared_distance = kInfinity;
  Vec3 on_segment = Vec3::Zero(), on_mesh = Vec3::Zero();
  int triangle = -1;
};

Vec3 normal_of(const MeshSolid::Triangle& t) { return (t.b - t.a).cross(t.c - t.a); }

Vec3 unit_normal_of(const MeshSolid::Triangle& t) {
  const Vec3 normal = normal_of(t);
  return normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
}

/// Computes the foot of a point on the triangle's plane; returns true if it lies in the triangle.
bool find_foot(const MeshSolid::Triangle& t, const Vec3& normal, const Vec3& point, Vec3& foot) {
  const double squared_length = normal.squaredNorm();
  if (!(squared_length > 0)) return false;
  foot = point - normal.dot(point - t.a) / squared_length * normal;
  return normal.dot((t.b - t.a).cross(foot - t.a)) >= 0 &&
         normal.dot((t.c - t.b).cross(foot - t.b)) >= 0 &&
         normal.dot((t.a - t.c).cross(foot - t.c)) >= 0;
}

/// Replaces `nearest` if triangle k is nearer to the segment. The nearest points are an
/// intersection, an end point and its foot, or a point of the segment and one of an edge.
void try_triangle(const MeshSolid& mesh, int k, const Vec3& from, const Vec3& to,
                  Nearest& nearest) {
  const MeshSolid::Triangle& t = mesh.triangles[k];
  const Vec3 normal = normal_of(t);
  const auto try_points = [&](const Vec3& on_segment, const Vec3& on_mesh, double squared) {
    if (squared < nearest.squared_distance) nearest = {squared, on_segment, on_mesh, k};
  };
  Vec3 foot;
  const double from_height = normal.dot(from - t.a), to_height = normal.dot(to - t.a);
  if ((from_height > 0) != (to_height > 0)) {
    const Vec3 crossing = from + from_height / (from_height - to_height) * (to - from);
    if (find_foot(t, normal, crossing, foot)) try_points(foot, foot, 0);
  }
  if (find_foot(t, normal, from, foot)) try_points(from, foot, (from - foot).squaredNorm());
  if (from != to && find_foot(t, normal, to, foot)) try_points(to, foot, (to - foot).squaredNorm());
  const Vec3* corners[] = {&t.a, &t.b, &t.c, &t.a};
  for (int e = 0; e < 3; ++e) {
    const auto [on_segment, on_edge, squared] =
        closest_points_of_segments(from, to, *corners[e], *corners[e + 1]);
    try_points(on_segment, on_edge, squared);
  }
}

/// Returns the squared distance between a node's bounding box and that with the corners low, high.
double squared_box_distance(const MeshSolid::Node& node, const Vec3& low, const Vec3& high) {
  return (node.low - high).cwiseMax(low - node.high).cwiseMax(0.0).squaredNorm();
}

/// Finds the nearest triangle below a node; low and high are the corners of the segment's box.
void descend(const MeshSolid& mesh, int root, const Vec3& from, const Vec3& to, const Vec3& low,
             const Vec3& high, Nearest& nearest) {
  const MeshSolid::Node& node = mesh.nodes[root];
  if (node.count > 0) {
    for (int k = node.first; k < node.first + node.count; ++k)
      try_triangle(mesh, k, from, to, nearest);
    return;
  }
  const double left = squared_box_distance(mesh.nodes[node.left], low, high);
  const double right = squared_box_distance(mesh.nodes[node.right], low, high);
  const auto [nearer, farther] =
      left <= right ? std::pair(node.left, node.right) : std::pair(node.right, node.left);
  if (std::min(left, right) < nearest.squared_distance)
    descend(mesh, nearer, from, to, low, high, nearest);
  if (std::max(left, right) < nearest.squared_distance)
    descend(mesh, farther, from, to, low, high, nearest);
}

Nearest nearest_points(const MeshSolid& mesh, const Vec3& from, const Vec3& to) {
  Nearest nearest;
  descend(mesh, 0, from, to, from.cwiseMin(to), from.cwiseMax(to), nearest);
  return nearest;
}

/// A point, its depth in the solid (< 0 outside) and the nearest point of the surface.
struct Depth {
  double depth = 0;
  Vec3 point = Vec3::Zero(), surface = Vec3::Zero();
};

Depth depth_at(const MeshSolid& mesh, const Vec3& point) {
  const Nearest nearest = nearest_points(mesh, point, point);
  const double distance = std::sqrt(nearest.squared_distance);
  return {is_inside(mesh, point) ? distance : -distance, point, nearest.on_mesh};
}

/// Returns the deepest point found on the segment, or `start` if that is deeper, and as `bound_m`
/// an upper bound of the depth of all points. Along the segment, the depth changes by at most the
/// distance. Pieces that may hold a point beyond the tolerance are bisected, the deepest first.
Depth deepest_mesh_point(const MeshSolid& mesh, const Vec3& from, const Vec3& to,
                         const Depth& start, double& bound_m) {
  struct Piece {
    double low, high, max_depth_m;  ///< parameters, and upper bound of the depth within
    bool operator<(const Piece& other) const { return max_depth_m < other.max_depth_m; }
  };
  const double length = (to - from).norm();
  std::priority_queue<Piece> pieces;
  Depth deepest = start;
  const auto add = [&](double low, double high) {
    const Depth middle = depth_at(mesh, from + 0.5 * (low + high) * (to - from));
    if (middle.depth > deepest.depth) deepest = middle;
    pieces.push({low, high, middle.depth + 0.5 * (high - low) * length});
  };
  add(0, 1);
  while (pieces.top().max_depth_m > kMeshDepthFactor * deepest.depth + kMeshDepthTolerance_m) {
    const Piece piece = pieces.top();
    pieces.pop();
    const double middle = 0.5 * (piece.low + piece.high);
    add(piece.low, middle);
    add(middle, piece.high);
  }
  bound_m = std::max(deepest.depth, pieces.top().max_depth_m);
  return deepest;
}

}  // namespace

double mesh_distance_lower_bound(const MeshSolid& mesh, const Vec3& point) {
  const double squared = squared_box_distance(mesh.nodes.front(), point, point);
  return squared > 0 ? std::sqrt(squared) : -kInfinity;
}

double mesh_distance(const MeshSolid& mesh, const Vec3& point, Vec3& gradient) {
  const Nearest nearest = nearest_points(mesh, point, point);
  const double sign = is_inside(mesh, point) ? -1 : 1;
  const double distance = std::sqrt(nearest.squared_distance);
  gradient = distance > kCoincidence_m ? Vec3(sign * (point - nearest.on_mesh) / distance)
                                       : unit_normal_of(mesh.triangles[nearest.triangle]);
  return sign * distance;
}

Separation capsule_mesh(const CapsuleBody& capsule, const MeshSolid& mesh) {
  const Nearest nearest = nearest_points(mesh, capsule.from, capsule.to);
  const double distance = std::sqrt(nearest.squared_distance);
  Separation result{distance, nearest.on_segment, nearest.on_mesh, Vec3()};
  if (distance > kCoincidence_m) {
    result.normal = (nearest.on_segment - nearest.on_mesh) / distance;
  } else {
    // The segment intersects the surface: the normal points to the side of its longer part.
    result.normal = unit_normal_of(mesh.triangles[nearest.triangle]);
    if (result.normal.dot(capsule.from + capsule.to - 2 * nearest.on_mesh) < 0)
      result.normal = -result.normal;
  }
  // A segment that does not intersect the surface is on one side of it.
  if (distance <= kCoincidence_m || is_inside(mesh, capsule.from)) {
    double max_depth = 0;
    const Depth start{0, nearest.on_segment, nearest.on_mesh};
    const Depth deepest = deepest_mesh_point(mesh, capsule.from, capsule.to, start, max_depth);
    result.distance = -max_depth;
    result.on_first = deepest.point;
    result.on_second = deepest.surface;
    if (deepest.depth > kCoincidence_m)
      result.normal = (deepest.surface - deepest.point) / deepest.depth;
  }
  result.distance -= capsule.radius;
  result.on_first -= capsule.radius * result.normal;
  return result;
}

}  // namespace morphe::collision
