#include "stages/verify/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morphe::verify {
namespace {

constexpr double kMinClearDistance_m = 1e-9;
constexpr int kMaxSegmentBisections = 20000;  ///< in the search for a segment's depth

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

/// Returns the distance between a triangle and a segment: the least of the distances of the
/// triangle to the segment's ends and to its intersection with the triangle's plane, and of its
/// edges to the segment.
double triangle_distance(const Mesh::Triangle& t, const Segment& s) {
  double least =
      std::min({face_distance(t, s.from), face_distance(t, s.to), segment_distance(s, {t.a, t.b}),
                segment_distance(s, {t.b, t.c}), segment_distance(s, {t.c, t.a})});
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  const double above = normal.dot(s.from - t.a), below = normal.dot(s.to - t.a);
  if ((above > 0) != (below > 0))
    least = std::min(least, face_distance(t, s.from + above / (above - below) * (s.to - s.from)));
  return least;
}

/// Returns a segment's unsigned distance to the surface; from `enough` on, a lower bound of it.
double surface_distance(const Mesh& mesh, const Segment& segment, double enough) {
  const auto lower_bound = [&](const Mesh::Cluster& cluster) {
    return segment_distance(segment, {cluster.centre, cluster.centre}) - cluster.radius;
  };
  const double mesh_bound = lower_bound(mesh.ball);
  if (mesh_bound >= enough) return mesh_bound;
  std::vector<double> bounds;
  for (const Mesh::Cluster& cluster : mesh.clusters) bounds.push_back(lower_bound(cluster));
  const auto nearest = std::ranges::min_element(bounds);
  if (*nearest >= enough) return *nearest;
  double least = kInfinity;
  const auto search = [&](const Mesh::Cluster& cluster) {
    for (int t = cluster.begin; t < cluster.end; ++t)
      least = std::min(least, triangle_distance(mesh.triangles[t], segment));
  };
  search(mesh.clusters[nearest - bounds.begin()]);
  for (int k = 0; k < std::ssize(bounds); ++k)
    if (bounds[k] < least) search(mesh.clusters[k]);
  return least;
}

/// Returns true if a point lies to the left of the line from a to b, seen along x. On the line it
/// is on opposite sides of a–b and b–a, so that a ray hits one of two triangles beside an edge.
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

/// Raises `max_depth` to a segment's largest depth, to 5 % + 10 um; to an upper bound of it without
/// bisections left. Between two points the depth changes by at most their distance.
void raise_to_depth(const Mesh& mesh, const Segment& segment, int& bisections_left,
                    double& max_depth) {
  const Vec3 middle = 0.5 * (segment.from + segment.to);
  const double distance = surface_distance(mesh, {middle, middle}, kInfinity);
  const double depth = is_inside(mesh, middle) ? distance : -distance;
  max_depth = std::max(max_depth, depth);
  const double bound = depth + 0.5 * (segment.to - segment.from).norm();
  if (bound <= 1.05 * max_depth + 1e-5) return;
  if (--bisections_left < 0) {
    max_depth = std::max(max_depth, bound);
    return;
  }
  raise_to_depth(mesh, {segment.from, middle}, bisections_left, max_depth);
  raise_to_depth(mesh, {middle, segment.to}, bisections_left, max_depth);
}

}  // namespace

bool is_inside(const Mesh& mesh, const Vec3& point) {
  const Mesh::Cluster& ball = mesh.ball;
  if ((point - ball.centre).squaredNorm() > ball.radius * ball.radius) return false;
  std::vector<char> odd(mesh.watertight.size(), 0);
  for (const Mesh::Cluster& cluster : mesh.clusters) {
    const bool missed = point.y() < cluster.low.y() || point.y() > cluster.high.y() ||
                        point.z() < cluster.low.z() || point.z() > cluster.high.z() ||
                        point.x() > cluster.high.x();
    if (missed) continue;
    for (int t = cluster.begin; t < cluster.end; ++t) {
      char& crossed = odd[mesh.triangles[t].component];
      if (ray_hits_triangle(mesh.triangles[t], point)) crossed = !crossed;
    }
  }
  for (int component = 0; component < std::ssize(odd); ++component)
    if (mesh.watertight[component] && odd[component]) return true;
  return false;
}

double segment_mesh_distance(const Mesh& mesh, const Segment& segment, double enough) {
  const double distance = surface_distance(mesh, segment, enough);
  // A segment that is clear of all surfaces is entirely inside or entirely outside.
  if (distance > kMinClearDistance_m && !is_inside(mesh, segment.from)) return distance;
  double deepest = 0;
  int bisections_left = kMaxSegmentBisections;
  raise_to_depth(mesh, segment, bisections_left, deepest);
  return -deepest;
}

}  // namespace morphe::verify
