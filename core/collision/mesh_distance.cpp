#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/collision/closest_points.hpp"
#include "core/collision/mesh_solid.hpp"

namespace morphe::collision {
namespace {

constexpr double kContactTolerance_m = 1e-12;

struct Nearest {
  double squared = kInfinity;
  Vec3 on_segment = Vec3::Zero(), on_mesh = Vec3::Zero();
  int triangle = -1;
};

Vec3 normal_of(const MeshSolid::Triangle& t) { return (t.b - t.a).cross(t.c - t.a); }

/// Computes the projection of the point onto the triangle's plane; returns true if it lies in the
/// triangle.
bool foot_in(const MeshSolid::Triangle& t, const Vec3& normal, const Vec3& point, Vec3& foot) {
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return false;
  foot = point - normal.dot(point - t.a) / squared * normal;
  return normal.dot((t.b - t.a).cross(foot - t.a)) >= 0 &&
         normal.dot((t.c - t.b).cross(foot - t.b)) >= 0 &&
         normal.dot((t.a - t.c).cross(foot - t.c)) >= 0;
}

/// Updates the nearest points with a triangle. They are an intersection, an end point and its
/// projection, or a point of the segment and one of an edge.
void try_triangle(const MeshSolid& mesh, int k, const Vec3& from, const Vec3& to, Nearest& best) {
  const MeshSolid::Triangle& t = mesh.triangles[k];
  const Vec3 normal = normal_of(t);
  const auto keep = [&](const Vec3& on_segment, const Vec3& on_mesh, double squared) {
    if (squared < best.squared) best = {squared, on_segment, on_mesh, k};
  };
  Vec3 foot;
  const double above = normal.dot(from - t.a), beyond = normal.dot(to - t.a);
  if ((above > 0) != (beyond > 0)) {
    const Vec3 crossing = from + above / (above - beyond) * (to - from);
    if (foot_in(t, normal, crossing, foot)) keep(foot, foot, 0);
  }
  if (foot_in(t, normal, from, foot)) keep(from, foot, (from - foot).squaredNorm());
  if (from != to && foot_in(t, normal, to, foot)) keep(to, foot, (to - foot).squaredNorm());
  const Vec3* corners[] = {&t.a, &t.b, &t.c, &t.a};
  for (int e = 0; e < 3; ++e) {
    const ClosestPoints near = closest_points_of_segments(from, to, *corners[e], *corners[e + 1]);
    keep(near.on_first, near.on_second, near.squared);
  }
}

/// Returns a lower bound of the squared distance between the segment's bounding box and the node's.
double squared_distance_lower_bound(const MeshSolid::Node& node, const Vec3& low,
                                    const Vec3& high) {
  return (node.low - high).cwiseMax(low - node.high).cwiseMax(0.0).squaredNorm();
}

void descend(const MeshSolid& mesh, int at, const Vec3& from, const Vec3& to, const Vec3& low,
             const Vec3& high, Nearest& best) {
  const MeshSolid::Node& node = mesh.nodes[at];
  if (node.count > 0) {
    for (int k = node.first; k < node.first + node.count; ++k) {
      try_triangle(mesh, k, from, to, best);
    }
    return;
  }
  const auto bound = [&](int child) {
    return squared_distance_lower_bound(mesh.nodes[child], low, high);
  };
  const double left = bound(node.left), right = bound(node.right);
  const bool left_first = left <= right;
  if (std::min(left, right) < best.squared) {
    descend(mesh, left_first ? node.left : node.right, from, to, low, high, best);
  }
  if (std::max(left, right) < best.squared) {
    descend(mesh, left_first ? node.right : node.left, from, to, low, high, best);
  }
}

Nearest nearest_points(const MeshSolid& mesh, const Vec3& from, const Vec3& to) {
  Nearest best;
  descend(mesh, 0, from, to, from.cwiseMin(to), from.cwiseMax(to), best);
  return best;
}

/// A point of the segment and its depth in the solid, < 0 outside.
struct Depth {
  double depth = 0;
  Vec3 point = Vec3::Zero(), surface = Vec3::Zero();
};

Depth depth_at(const MeshSolid& mesh, const Vec3& point) {
  const Nearest near = nearest_points(mesh, point, point);
  const double apart = std::sqrt(near.squared);
  return {is_inside(mesh, point) ? apart : -apart, point, near.on_mesh};
}

/// Returns the deepest point of the segment, if it is deeper than `start`. The depth changes by at
/// most the distance along the segment, so pieces that may contain a point deeper than the
/// tolerance allows are bisected, the most promising first. `bound` is an upper bound of the depth
/// of all points.
Depth deepest_mesh_point(const MeshSolid& mesh, const Vec3& from, const Vec3& to,
                         const Depth& start, double& bound) {
  struct Piece {
    double low, high, most;  ///< parameters, and upper bound of the depth within [m]
    bool operator<(const Piece& other) const { return most < other.most; }
  };
  const double length = (to - from).norm();
  std::priority_queue<Piece> pieces;
  Depth best = start;
  const auto add = [&](double low, double high) {
    const Depth middle = depth_at(mesh, from + 0.5 * (low + high) * (to - from));
    if (middle.depth > best.depth) best = middle;
    pieces.push({low, high, middle.depth + 0.5 * (high - low) * length});
  };
  add(0, 1);
  const auto enough = [&] { return 1.05 * best.depth + 1e-5; };
  while (pieces.top().most > enough()) {
    const Piece piece = pieces.top();
    pieces.pop();
    const double middle = 0.5 * (piece.low + piece.high);
    add(piece.low, middle);
    add(middle, piece.high);
  }
  bound = std::max(best.depth, pieces.top().most);
  return best;
}

}  // namespace

double mesh_distance_lower_bound(const MeshSolid& mesh, const Vec3& point) {
  const double squared = squared_distance_lower_bound(mesh.nodes.front(), point, point);
  return squared > 0 ? std::sqrt(squared) : -kInfinity;
}

double mesh_distance(const MeshSolid& mesh, const Vec3& point, Vec3& gradient) {
  const Nearest near = nearest_points(mesh, point, point);
  const double sign = is_inside(mesh, point) ? -1 : 1, apart = std::sqrt(near.squared);
  const Vec3 normal = normal_of(mesh.triangles[near.triangle]);
  gradient = apart > kContactTolerance_m ? Vec3(sign * (point - near.on_mesh) / apart)
             : normal.norm() > 0         ? Vec3(normal.normalized())
                                         : Vec3(Vec3::UnitZ());
  return sign * apart;
}

Separation capsule_mesh(const CapsuleBody& capsule, const MeshSolid& mesh) {
  const Nearest near = nearest_points(mesh, capsule.from, capsule.to);
  const double apart = std::sqrt(near.squared);
  Separation result;
  result.distance = apart;
  result.on_first = near.on_segment;
  result.on_second = near.on_mesh;
  if (apart > kContactTolerance_m) {
    result.normal = (near.on_segment - near.on_mesh) / apart;
  } else {
    // The segment intersects the surface: the normal points to the side of its longer part.
    const Vec3 normal = normal_of(mesh.triangles[near.triangle]);
    result.normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
    if (result.normal.dot(capsule.from + capsule.to - 2 * near.on_mesh) < 0) {
      result.normal = -result.normal;
    }
  }
  // Away from every surface, the whole segment is on one side.
  if (apart <= kContactTolerance_m || is_inside(mesh, capsule.from)) {
    double bound = 0;
    const Depth start{0, near.on_segment, near.on_mesh};
    const Depth most = deepest_mesh_point(mesh, capsule.from, capsule.to, start, bound);
    result.distance = -bound;
    result.on_first = most.point;
    result.on_second = most.surface;
    if (most.depth > kContactTolerance_m) result.normal = (most.surface - most.point) / most.depth;
  }
  result.distance -= capsule.radius;
  result.on_first -= capsule.radius * result.normal;
  return result;
}

}  // namespace morphe::collision
