#include "stages/verify/body_distance.hpp"

#include <algorithm>

#include "stages/verify/convex_gap.hpp"

namespace morphe::verify {
namespace {

/// Depth from which on a mesh is not measured any further: deeper than any that is allowed.
constexpr double kDeepEnough_m = 0.01;

bool is_mesh(const PlacedBody& body) { return body.object.shape == Shape::mesh; }

ConvexShape convex_shape(const PlacedBody& body) { return {&body.object, body.pose}; }

ConvexShape convex_shape(const Mesh::Triangle& t, const Pose& pose) {
  return {nullptr, Pose::Identity(), {pose * t.a, pose * t.b, pose * t.c}};
}

/// Returns the distance of two balls.
double ball_gap(const Vec3& a, double radius_a, const Vec3& b, double radius_b) {
  return (a - b).norm() - radius_a - radius_b;
}

/// Lowers `least` to minus the depth of a point in the solid of a mesh.
void lower_to_depth(const PlacedBody& mesh, const Vec3& point, double& least) {
  const Vec3 local = mesh.pose.inverse() * point;
  if (is_inside(mesh.mesh, local))
    least = std::min(least, segment_mesh_distance(mesh.mesh, {local, local}, kInfinity));
}

double least_of_mesh_and_convex(const PlacedBody& mesh, const PlacedBody& other) {
  const double radius = bounding_radius(other.object);
  const Vec3 centre = other.pose.translation();
  const ConvexShape shape = convex_shape(other);
  double least = kInfinity;
  for (const Mesh::Cluster& cluster : mesh.mesh.clusters) {
    // Inside a large body, the distance of balls is no bound of the depth.
    const Vec3 local = other.pose.inverse() * (mesh.pose * cluster.centre);
    if (signed_distance(other.object, local) - cluster.radius >= least) continue;
    if (least < -kDeepEnough_m) return least;
    for (int t = cluster.begin; t < cluster.end; ++t)
      least = std::min(least, convex_gap(convex_shape(mesh.mesh.triangles[t], mesh.pose), shape));
  }
  if (ball_gap(mesh.pose * mesh.mesh.ball.centre, mesh.mesh.ball.radius, centre, radius) < 0)
    lower_to_depth(mesh, centre, least);
  return least;
}

void lower_to_vertices(const PlacedBody& inner, const PlacedBody& outer, double& least) {
  for (const Mesh::Triangle& t : inner.mesh.triangles) {
    if (least < -kDeepEnough_m) return;
    for (const Vec3& corner : {t.a, t.b, t.c}) lower_to_depth(outer, inner.pose * corner, least);
  }
}

double least_of_meshes(const PlacedBody& a, const PlacedBody& b) {
  double least = kInfinity;
  for (const Mesh::Cluster& own : a.mesh.clusters) {
    for (const Mesh::Cluster& other : b.mesh.clusters) {
      if (ball_gap(a.pose * own.centre, own.radius, b.pose * other.centre, other.radius) >= least)
        continue;
      if (least < -kDeepEnough_m) return least;
      for (int i = own.begin; i < own.end; ++i)
        for (int k = other.begin; k < other.end; ++k)
          least = std::min(least, convex_gap(convex_shape(a.mesh.triangles[i], a.pose),
                                             convex_shape(b.mesh.triangles[k], b.pose)));
    }
  }
  lower_to_vertices(a, b, least);
  lower_to_vertices(b, a, least);
  return least;
}

/// Returns a lower bound of the distance: of an object from a ball about another.
double ball_bound(const PlacedBody& a, const PlacedBody& b) {
  const Vec3 centre = b.pose.inverse() * a.pose.translation();
  if (is_mesh(b))
    return ball_gap(centre, bounding_radius(a.object), b.mesh.ball.centre, b.mesh.ball.radius);
  return signed_distance(b.object, centre) - bounding_radius(a.object);
}

}  // namespace

double body_distance(const PlacedBody& a, const PlacedBody& b, double enough) {
  const double bound = std::max(ball_bound(a, b), ball_bound(b, a));
  if (bound >= enough && bound > 0) return bound;
  if (is_mesh(a) && is_mesh(b)) return least_of_meshes(a, b);
  if (is_mesh(a)) return least_of_mesh_and_convex(a, b);
  if (is_mesh(b)) return least_of_mesh_and_convex(b, a);
  return convex_gap(convex_shape(a), convex_shape(b));
}

}  // namespace morphe::verify
