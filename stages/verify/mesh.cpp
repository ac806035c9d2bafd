#include "stages/verify/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace morphe::verify {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTouching_m = 1e-9;
constexpr int kMaxSegmentParts = 20000;  ///< of a segment, to find how deep it lies

/// Distance of a point to a triangle's inner part, infinity if its foot lies beside it.
double face_distance(const Mesh::Triangle& t, const Vec3& point) {
  const Vec3 u = t.b - t.a, v = t.c - t.a, w = point - t.a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-24 * uu * vv)) return kInfinity;
  const double s = (vv * u.dot(w) - uv * v.dot(w)) / determinant;
  const double r = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
  return s >= 0 && r >= 0 && s + r <= 1 ? (w - s * u - r * v).norm() : kInfinity;
}

/// Nearest are an end or the place where the segment passes the triangle's plane and their foot on
/// the triangle, or the segment and an edge. What is no foot is no nearer than the least.
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

/// Unsigned. What is at least `enough` need not be exact.
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
  search(static_cast<std::size_t>(nearest - bounds.begin()));
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    if (bounds[k] < best) search(k);
  }
  return best;
}

/// On which side of the line a–b the point lies, all seen along x. A point on the line is taken to
/// lie a little above it, the same for both triangles that share the edge.
bool left_of(const Vec3& a, const Vec3& b, const Vec3& point) {
  const bool forward = std::pair(a.y(), a.z()) < std::pair(b.y(), b.z());
  const Vec3 &from = forward ? a : b, &to = forward ? b : a;
  const double area =
      (to.y() - from.y()) * (point.z() - from.z()) - (to.z() - from.z()) * (point.y() - from.y());
  return (area >= 0) == forward;
}

/// Whether the ray from the point along +x goes through the triangle.
bool ahead(const Mesh::Triangle& t, const Vec3& point) {
  const bool left = left_of(t.a, t.b, point);
  if (left != left_of(t.b, t.c, point) || left != left_of(t.c, t.a, point)) return false;
  const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
  return normal.x() != 0 && normal.dot(t.a - point) / normal.x() > 0;
}

/// How deep the segment's deepest point lies; no point is nearer to it than the way along it tells.
/// Where it was halved too often, as deep as it may lie.
void deepen(const Mesh& mesh, const Segment& segment, int& parts, double& deepest) {
  const Vec3 middle = 0.5 * (segment.from + segment.to);
  const double apart = surface_distance(mesh, {middle, middle}, kInfinity);
  const double depth = inside(mesh, middle) ? apart : -apart;
  deepest = std::max(deepest, depth);
  const double most = depth + 0.5 * (segment.to - segment.from).norm();
  if (most <= 1.05 * deepest + 1e-5) return;
  if (--parts < 0) {
    deepest = std::max(deepest, most);
    return;
  }
  deepen(mesh, {segment.from, middle}, parts, deepest);
  deepen(mesh, {middle, segment.to}, parts, deepest);
}

}  // namespace

bool inside(const Mesh& mesh, const Vec3& point) {
  const Mesh::Cluster& ball = mesh.ball;
  if ((point - ball.centre).squaredNorm() > ball.radius * ball.radius) return false;
  std::vector<char> odd(mesh.closed.size(), 0);
  for (const Mesh::Cluster& cluster : mesh.clusters) {
    const bool beside = point.y() < cluster.low.y() || point.y() > cluster.high.y() ||
                        point.z() < cluster.low.z() || point.z() > cluster.high.z() ||
                        point.x() > cluster.high.x();
    if (beside) continue;
    for (std::size_t t = cluster.begin; t < cluster.end; ++t) {
      char& side = odd[static_cast<std::size_t>(mesh.triangles[t].part)];
      if (ahead(mesh.triangles[t], point)) side = !side;
    }
  }
  for (std::size_t part = 0; part < mesh.closed.size(); ++part) {
    if (mesh.closed[part] && odd[part]) return true;
  }
  return false;
}

double segment_mesh_distance(const Mesh& mesh, const Segment& segment, double enough) {
  const double apart = surface_distance(mesh, segment, enough);
  // Clear of all surfaces it is inside as a whole, or not at all.
  if (apart > kTouching_m && !inside(mesh, segment.from)) return apart;
  double deepest = 0;
  int parts = kMaxSegmentParts;
  deepen(mesh, segment, parts, deepest);
  return -deepest;
}

}  // namespace morphe::verify
