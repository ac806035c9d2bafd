#include "stages/verify/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace morphe::verify {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMinClearDistance_m = 1e-9;
/// maximum number of bisections of a segment to find its depth
constexpr int kMaxSegmentBisections = 20000;

/// Returns the distance of a point to a triangle's interior; infinity if the foot of the
/// perpendicular is outside of the triangle.
double face_distance(const Mesh::Triangle& t, const Vec3& point) {
  const Vec3 u = t.b - t.a, v = t.c - t.a, w = point - t.a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-24 * uu * vv)) return kInfinity;
  const double s = (vv * u.dot(w) - uv * v.dot(w)) / determinant;
  const double r = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
  return s >= 0 && r >= 0 && s + r <= 1 ? (w - s * u - r * v).norm() : kInfinity;
}

/// Returns the distance between a triangle and a segment. The nearest points are an end of the
/// segment, or its intersection with the triangle's plane, with their feet on the triangle; or they
/// are on the segment and an edge. A candidate without a foot is no closer than the minimum.
double triangle_distance(const Mesh::Triangle& t, const Segment& s) {
  double least =
      std::min({face_distance(t, s.from), face_distance(t, s.to), segment_distance(s, {t.a, t.b}),
                segment_distance(s, {t.b, t.c}), segment_distance(s, {t.c, t.a})});
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double above = normal.dot(s.from - t.a), below = normal.dot(s.to - t.a);
  if ((above > 0) != (below > 0)) {
    least = std::min(least, face_distance(t, s.from + above / (above - below) * (s.to - s.from)));
  }
  return least;
}

/// Returns the unsigned distance of a segment to the surface. Values of at least `enough` need not
/// be exact.
double surface_distance(const Mesh& mesh, const Segment& segment, double enough) {
  const double whole =
      segment_distance(segment, {mesh.ball.centre, mesh.ball.centre}) - mesh.ball.radius;
  if (whole >= enough) return whole;
  std::vector<double> bounds;
  for (const Mesh::Cluster& cluster : mesh.clusters) {
    bounds.push_back(segment_distance(segment, {cluster.centre, cluster.centre}) - cluster.radius);
  }
  const auto nearest = std::ranges::min_element(bounds);
  if (*nearest >= enough) return *nearest;
  double best = kInfinity;
  const auto search = [&](std::size_t k) {
    for (std::size_t t = mesh.clusters[k].begin; t < mesh.clusters[k].end; ++t) {
      best = std::min(best, triangle_distance(mesh.triangles[t], segment));
    }
  };
  search(nearest - bounds.begin());
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    if (bounds[k] < best) search(k);
  }
  return best;
}

/// Returns the side of the line a–b on which the point lies, seen along x. A point on the line is
/// taken to be slightly above it, consistently for both triangles that share the edge.
bool left_of(const Vec3& a, const Vec3& b, const Vec3& point) {
  const bool forward = std::pair(a.y(), a.z()) < std::pair(b.y(), b.z());
  const Vec3 &from = forward ? a : b, &to = forward ? b : a;
  const double area =
      (to.y() - from.y()) * (point.z() - from.z()) - (to.z() - from.z()) * (point.y() - from.y());
  return (area >= 0) == forward;
}

/// Returns true if the ray from the point along +x passes through the triangle.
bool ray_hits_triangle(const Mesh::Triangle& t, const Vec3& point) {
  const bool left = left_of(t.a, t.b, point);
  if (left != left_of(t.b, t.c, point) || left != left_of(t.c, t.a, point)) return false;
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  return normal.x() != 0 && normal.dot(t.a - point) / normal.x() > 0;
}

/// Updates the depth of the segment's deepest point. The depth changes by at most the distance
/// along the segment. If the limit of bisections is reached, the upper bound of the depth is used.
void update_max_depth(const Mesh& mesh, const Segment& segment, int& parts, double& deepest) {
  const Vec3 middle = 0.5 * (segment.from + segment.to);
  const double apart = surface_distance(mesh, {middle, middle}, kInfinity);
  const double depth = is_inside(mesh, middle) ? apart : -apart;
  deepest = std::max(deepest, depth);
  const double most = depth + 0.5 * (segment.to - segment.from).norm();
  if (most <= 1.05 * deepest + 1e-5) return;
  if (--parts < 0) {
    deepest = std::max(deepest, most);
    return;
  }
  update_max_depth(mesh, {segment.from, middle}, parts, deepest);
  update_max_depth(mesh, {middle, segment.to}, parts, deepest);
}

}  // namespace

bool is_inside(const Mesh& mesh, const Vec3& point) {
  const Mesh::Cluster& ball = mesh.ball;
  if ((point - ball.centre).squaredNorm() > ball.radius * ball.radius) return false;
  std::vector<char> odd(mesh.watertight.size(), 0);
  for (const Mesh::Cluster& cluster : mesh.clusters) {
    const bool beside = point.y() < cluster.low.y() || point.y() > cluster.high.y() ||
                        point.z() < cluster.low.z() || point.z() > cluster.high.z() ||
                        point.x() > cluster.high.x();
    if (beside) continue;
    for (std::size_t t = cluster.begin; t < cluster.end; ++t) {
      char& side = odd[mesh.triangles[t].component];
      if (ray_hits_triangle(mesh.triangles[t], point)) side = !side;
    }
  }
  for (std::size_t part = 0; part < mesh.watertight.size(); ++part) {
    if (mesh.watertight[part] && odd[part]) return true;
  }
  return false;
}

double segment_mesh_distance(const Mesh& mesh, const Segment& segment, double enough) {
  const double apart = surface_distance(mesh, segment, enough);
  // A segment that is clear of all surfaces is entirely inside or entirely outside.
  if (apart > kMinClearDistance_m && !is_inside(mesh, segment.from)) return apart;
  double deepest = 0;
  int parts = kMaxSegmentBisections;
  update_max_depth(mesh, segment, parts, deepest);
  return -deepest;
}

}  // namespace morphe::verify
